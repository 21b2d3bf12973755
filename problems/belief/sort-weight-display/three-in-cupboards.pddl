; Three boxes in two closed cupboards, a scale and a bin.
(define (problem sort-weight-display-three-in-cupboards)
  (:domain sort-weight-display)
  (:objects box1 box2 box3 - box desk - table left right - cupboard balance - scale bin - light-bin)
  (:init
    (at desk) (hand-empty) (free balance)
    (oneof (on box1 left) (on box1 right))
    (oneof (on box2 left) (on box2 right))
    (oneof (on box3 left) (on box3 right))
    (unknown (heavy box1))
    (unknown (heavy box2))
    (unknown (heavy box3)))
  (:goal (forall (?b - box) (or (heavy ?b) (on ?b bin)))))
