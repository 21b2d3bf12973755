; Two boxes on a table, a scale and a bin.
(define (problem sort-weight-display-two)
  (:domain sort-weight-display)
  (:objects box1 box2 - box desk - table balance - scale bin - light-bin)
  (:init
    (at desk) (hand-empty) (free balance)
    (on box1 desk)
    (on box2 desk)
    (unknown (heavy box1))
    (unknown (heavy box2)))
  (:goal (forall (?b - box) (or (heavy ?b) (on ?b bin)))))
