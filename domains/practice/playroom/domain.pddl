; A robot sweeps toys into a bin. Before it can, the toys have to lie in the corner, the bin has to stand
; there, the chair has to be out of the way, and the sweeper is in a closet: ten skills and more.
;
; As skills: going, putting, closing and whatever is done with the bin and the sweeper alone always succeed;
; picking toys, opening the closet, pulling the chair, dumping and sweeping depend on their parameters.
(define (domain playroom)
  (:requirements :typing :equality)

  (:types
    place movable - object
    toy bin sweeper - movable)

  (:predicates
    (corner ?p - place)
    (closet ?p - place)
    (pair ?t ?u - toy)             ; the toys that are swept together
    (at ?p - place)
    (hand-empty)
    (holding ?m - movable)
    (on ?m - movable ?p - place)   ; the sweeper: in the closet there
    (in-bin ?t - toy)
    (closet-open)
    (closet-closed)
    (chair-in-corner)
    (chair-away))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action pick-toy
    :parameters (?t - toy ?p - place)
    :precondition (and (at ?p) (on ?t ?p) (hand-empty))
    :effect (and (not (on ?t ?p)) (not (hand-empty)) (holding ?t)))

  (:action put-toy
    :parameters (?t - toy ?p - place)
    :precondition (and (at ?p) (holding ?t))
    :effect (and (not (holding ?t)) (hand-empty) (on ?t ?p)))

  (:action pick-bin
    :parameters (?b - bin ?p - place)
    :precondition (and (at ?p) (on ?b ?p) (hand-empty))
    :effect (and (not (on ?b ?p)) (not (hand-empty)) (holding ?b)))

  (:action put-bin
    :parameters (?b - bin ?p - place)
    :precondition (and (at ?p) (holding ?b))
    :effect (and (not (holding ?b)) (hand-empty) (on ?b ?p)))

  (:action open-closet
    :parameters (?p - place)
    :precondition (and (at ?p) (closet ?p) (closet-closed) (hand-empty))
    :effect (and (not (closet-closed)) (closet-open)))

  (:action close-closet
    :parameters (?p - place)
    :precondition (and (at ?p) (closet ?p) (closet-open) (hand-empty))
    :effect (and (not (closet-open)) (closet-closed)))

  (:action take-sweeper
    :parameters (?s - sweeper ?p - place)
    :precondition (and (at ?p) (on ?s ?p) (closet-open) (hand-empty))
    :effect (and (not (on ?s ?p)) (not (hand-empty)) (holding ?s)))

  (:action put-sweeper-back
    :parameters (?s - sweeper ?p - place)
    :precondition (and (at ?p) (closet ?p) (closet-open) (holding ?s))
    :effect (and (not (holding ?s)) (hand-empty) (on ?s ?p)))

  (:action pull-chair-away
    :parameters (?p - place)
    :precondition (and (at ?p) (corner ?p) (chair-in-corner) (hand-empty))
    :effect (and (not (chair-in-corner)) (chair-away)))

  (:action push-chair-back
    :parameters (?p - place)
    :precondition (and (at ?p) (corner ?p) (chair-away) (hand-empty))
    :effect (and (not (chair-away)) (chair-in-corner)))

  (:action sweep
    :parameters (?t ?u - toy ?s - sweeper ?b - bin ?p - place)
    :precondition (and (at ?p) (corner ?p) (chair-away) (holding ?s) (on ?b ?p) (pair ?t ?u)
                       (on ?t ?p) (on ?u ?p))
    :effect (and (not (on ?t ?p)) (not (on ?u ?p)) (in-bin ?t) (in-bin ?u)))

  (:action dump
    :parameters (?t ?u - toy ?b - bin ?p - place)
    :precondition (and (at ?p) (corner ?p) (holding ?b) (pair ?t ?u) (in-bin ?t) (in-bin ?u))
    :effect (and (not (in-bin ?t)) (not (in-bin ?u)) (on ?t ?p) (on ?u ?p))))
