; Six cups on three tables; one is known to be full, and of two others one is.
(define (problem cup-removal-six)
  (:domain cup-removal)
  (:objects cup1 cup2 cup3 cup4 cup5 cup6 - cup left middle right - table waste - bin)
  (:init
    (at waste) (camera-down) (hand-empty)
    (on cup1 left) (on cup2 left) (on cup3 middle) (on cup4 middle) (on cup5 right) (on cup6 right)
    (full cup1)
    (unknown (full cup2)) (oneof (full cup3) (full cup4)) (unknown (full cup5)) (unknown (full cup6)))
  (:goal (forall (?c - cup) (or (full ?c) (on ?c waste)))))
