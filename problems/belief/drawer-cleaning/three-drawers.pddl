; Three drawers; a cup is in one of them or in none.
(define (problem drawer-cleaning-three)
  (:domain drawer-cleaning)
  (:objects drawer1 drawer2 drawer3 - drawer bin - box cup - thing)
  (:init
    (at bin) (hand-empty)
    (unknown (inside cup drawer1)) (unknown (inside cup drawer2)) (unknown (inside cup drawer3))
    (or (not (inside cup drawer1)) (not (inside cup drawer2)))
    (or (not (inside cup drawer1)) (not (inside cup drawer3)))
    (or (not (inside cup drawer2)) (not (inside cup drawer3))))
  (:goal (forall (?d - drawer) (and (empty ?d) (not (open ?d))))))
