; The sliding-tile puzzle: move tiles into the hole until all are in order.
;
; What it shows: plain STRIPS. No types, no negation, no quantifiers: predicates play every part.
(define (domain tiles)
  (:requirements :strips)

  (:predicates
    (tile ?t)
    (beside ?a ?b)                 ; two squares that share an edge
    (on ?t ?square)
    (hole ?square))

  (:action slide
    :parameters (?t ?from ?to)
    :precondition (and (tile ?t) (on ?t ?from) (hole ?to) (beside ?from ?to))
    :effect (and
      (not (on ?t ?from)) (on ?t ?to)
      (not (hole ?to)) (hole ?from))))
