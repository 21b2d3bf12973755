; One box in two closed cupboards, a scale and a bin.
(define (problem sort-weight-one-in-cupboards)
  (:domain sort-weight)
  (:objects box1 - box desk - table left right - cupboard balance - scale bin - light-bin)
  (:init
    (at desk) (hand-empty) (free balance)
    (oneof (on box1 left) (on box1 right))
    (unknown (heavy box1)))
  (:goal (forall (?b - box) (or (heavy ?b) (on ?b bin)))))
