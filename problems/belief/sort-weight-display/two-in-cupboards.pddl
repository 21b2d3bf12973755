; Two boxes in two closed cupboards, a scale and a bin.
(define (problem sort-weight-display-two-in-cupboards)
  (:domain sort-weight-display)
  (:objects box1 box2 - box desk - table left right - cupboard balance - scale bin - light-bin)
  (:init
    (at desk) (hand-empty) (free balance)
    (oneof (on box1 left) (on box1 right))
    (oneof (on box2 left) (on box2 right))
    (unknown (heavy box1))
    (unknown (heavy box2)))
  (:goal (forall (?b - box) (or (heavy ?b) (on ?b bin)))))
