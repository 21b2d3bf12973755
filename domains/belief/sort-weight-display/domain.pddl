; Sort closed boxes by weight, with a scale that has to be read.
;
; What it shows: the same errand as sort-weight with explicit sensing: reading the display is an action of its own.
(define (domain sort-weight-display)
  (:requirements :adl :contingent)

  (:types box place - object
          table cupboard scale light-bin - place)

  (:predicates
    (at ?p - place)                ; where the robot stands
    (on ?b - box ?p - place)       ; or in; of cupboards unknown at first
    (heavy ?b - box)               ; unknown at first
    (open ?c - cupboard)
    (holding ?b - box)
    (hand-empty)
    (free ?s - scale))             ; room for one box

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action open-cupboard
    :parameters (?c - cupboard)
    :precondition (and (at ?c) (hand-empty) (not (open ?c)))
    :effect (open ?c)
    :observe (forall (?b - box) (on ?b ?c)))

  (:action look-inside
    :parameters (?c - cupboard)
    :precondition (and (at ?c) (open ?c))
    :observe (forall (?b - box) (on ?b ?c)))

  (:action take-from-table
    :parameters (?b - box ?t - table)
    :precondition (and (at ?t) (hand-empty) (on ?b ?t))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?t))))

  (:action take-from-cupboard
    :parameters (?b - box ?c - cupboard)
    :precondition (and (at ?c) (open ?c) (hand-empty) (on ?b ?c))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?c))))

  (:action put-on-table
    :parameters (?b - box ?t - table)
    :precondition (and (at ?t) (holding ?b))
    :effect (and (on ?b ?t) (not (holding ?b)) (hand-empty)))

  (:action put-on-scale
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (holding ?b) (free ?s))
    :effect (and (on ?b ?s) (not (free ?s)) (not (holding ?b)) (hand-empty)))

  (:action read-display
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (on ?b ?s))
    :observe (heavy ?b))

  (:action take-from-scale
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (hand-empty) (on ?b ?s))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?s)) (free ?s)))

  ; A heavy box would break the bin: it is not allowed, so it must be known not to be heavy.
  (:action drop
    :parameters (?b - box ?l - light-bin)
    :precondition (and (at ?l) (holding ?b) (not (heavy ?b)))
    :effect (and (on ?b ?l) (not (holding ?b)) (hand-empty))))
