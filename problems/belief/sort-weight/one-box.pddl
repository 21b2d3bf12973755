; One box on a table, a scale and a bin.
(define (problem sort-weight-one)
  (:domain sort-weight)
  (:objects box1 - box desk - table balance - scale bin - light-bin)
  (:init
    (at desk) (hand-empty) (free balance)
    (on box1 desk)
    (unknown (heavy box1)))
  (:goal (forall (?b - box) (or (heavy ?b) (on ?b bin)))))
