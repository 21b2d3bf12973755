; Couriers with different tariffs deliver letters; every cost is an exact decimal number.
;
; What it shows: static functions, arithmetic in action costs, rational numbers (never rounded).
;
; A ride costs the distance times the tariff of the vehicle plus the toll of the road: 2.5 km at 0.35 with a toll of
; 1.2 is 2.075, exactly.
(define (domain courier)
  (:requirements :strips :typing :action-costs :numeric-fluents)

  (:types place vehicle letter - object
          bicycle van - vehicle)

  (:predicates
    (road ?from ?to - place)
    (lane ?from ?to - place)       ; a short cut for bicycles
    (at ?v - vehicle ?p - place)
    (lies ?l - letter ?p - place)
    (aboard ?l - letter ?v - vehicle))

  (:functions
    (distance ?from ?to - place) - number
    (toll ?from ?to - place) - number
    (tariff ?v - vehicle) - number
    (handling) - number
    (total-cost) - number)

  (:action ride
    :parameters (?v - vehicle ?from ?to - place)
    :precondition (and (at ?v ?from) (road ?from ?to))
    :effect (and
      (not (at ?v ?from)) (at ?v ?to)
      (increase (total-cost) (+ (* (distance ?from ?to) (tariff ?v)) (toll ?from ?to)))))

  ; No toll on a bicycle lane, and only half of the distance counts.
  (:action cycle
    :parameters (?v - bicycle ?from ?to - place)
    :precondition (and (at ?v ?from) (lane ?from ?to))
    :effect (and
      (not (at ?v ?from)) (at ?v ?to)
      (increase (total-cost) (/ (* (distance ?from ?to) (tariff ?v)) 2))))

  (:action load
    :parameters (?l - letter ?v - vehicle ?p - place)
    :precondition (and (at ?v ?p) (lies ?l ?p))
    :effect (and (not (lies ?l ?p)) (aboard ?l ?v) (increase (total-cost) (handling))))

  (:action unload
    :parameters (?l - letter ?v - vehicle ?p - place)
    :precondition (and (at ?v ?p) (aboard ?l ?v))
    :effect (and (not (aboard ?l ?v)) (lies ?l ?p) (increase (total-cost) (handling)))))
