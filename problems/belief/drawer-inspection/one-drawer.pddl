; One drawer with none, one or both of two cups in it.
(define (problem drawer-inspection-one)
  (:domain drawer-inspection)
  (:objects drawer1 - drawer bin - box red-cup blue-cup - thing)
  (:init
    (at bin) (hand-empty)
    (unknown (inside red-cup drawer1))
    (unknown (inside blue-cup drawer1)))
  (:goal (forall (?d - drawer) (and (empty ?d) (not (open ?d))))))
