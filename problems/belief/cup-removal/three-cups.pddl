; Three cups on two tables.
(define (problem cup-removal-three)
  (:domain cup-removal)
  (:objects cup1 cup2 cup3 - cup left right - table waste - bin)
  (:init
    (at waste) (camera-down) (hand-empty)
    (on cup1 left) (on cup2 left) (on cup3 right)
    (unknown (full cup1)) (unknown (full cup2)) (unknown (full cup3)))
  (:goal (forall (?c - cup) (or (full ?c) (on ?c waste)))))
