; Two cups have to come into the box; each is in one of three drawers. The robot need not open all of them.
(define (problem drawer-cleaning-find)
  (:domain drawer-cleaning)
  (:objects drawer1 drawer2 drawer3 - drawer bin - box red-cup blue-cup - thing)
  (:init
    (at bin) (hand-empty)
    (oneof (inside red-cup drawer1) (inside red-cup drawer2) (inside red-cup drawer3))
    (oneof (inside blue-cup drawer1) (inside blue-cup drawer2) (inside blue-cup drawer3)))
  (:goal (and
    (forall (?t - thing) (inside ?t bin))
    (forall (?d - drawer) (not (open ?d))))))
