; Two drawers and two cups; each cup is in one of the drawers or in none.
(define (problem drawer-cleaning-two)
  (:domain drawer-cleaning)
  (:objects drawer1 drawer2 - drawer bin - box red-cup blue-cup - thing)
  (:init
    (at bin) (hand-empty)
    (unknown (inside red-cup drawer1)) (unknown (inside red-cup drawer2))
    (or (not (inside red-cup drawer1)) (not (inside red-cup drawer2)))
    (unknown (inside blue-cup drawer1)) (unknown (inside blue-cup drawer2))
    (or (not (inside blue-cup drawer1)) (not (inside blue-cup drawer2))))
  (:goal (forall (?d - drawer) (and (empty ?d) (not (open ?d))))))
