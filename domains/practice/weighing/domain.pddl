; A robot with one hand weighs boxes on a scale; what is light goes into the bin.
;
; The errand of ../../belief/sort-weight-display, as it is rehearsed with boxes whose weight is known: reading the display
; is a skill that succeeds if what is read is right. No task needs the cupboard.
(define (domain weighing)
  (:requirements :typing :equality :negative-preconditions)

  (:types
    box place - object
    table scale light-bin cupboard - place)

  (:predicates
    (at ?p - place)                ; where the robot stands
    (on ?b - box ?p - place)       ; or in
    (holding ?b - box)
    (hand-empty)
    (free ?s - scale)              ; room for one box
    (weighed ?b - box)             ; the last reading of its weight was right
    (open ?c - cupboard))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action take-from-table
    :parameters (?b - box ?t - table)
    :precondition (and (at ?t) (hand-empty) (on ?b ?t))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?t))))

  (:action take-from-scale
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (hand-empty) (on ?b ?s))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?s)) (free ?s)))

  (:action take-from-bin
    :parameters (?b - box ?l - light-bin)
    :precondition (and (at ?l) (hand-empty) (on ?b ?l))
    :effect (and (holding ?b) (not (hand-empty)) (not (on ?b ?l))))

  (:action put-on-table
    :parameters (?b - box ?t - table)
    :precondition (and (at ?t) (holding ?b))
    :effect (and (on ?b ?t) (not (holding ?b)) (hand-empty)))

  (:action put-on-scale
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (holding ?b) (free ?s))
    :effect (and (on ?b ?s) (not (free ?s)) (not (holding ?b)) (hand-empty)))

  (:action drop
    :parameters (?b - box ?l - light-bin)
    :precondition (and (at ?l) (holding ?b) (weighed ?b))
    :effect (and (on ?b ?l) (not (holding ?b)) (hand-empty)))

  (:action read-display
    :parameters (?b - box ?s - scale)
    :precondition (and (at ?s) (on ?b ?s))
    :effect (weighed ?b))

  (:action open-cupboard
    :parameters (?c - cupboard)
    :precondition (and (at ?c) (hand-empty) (not (open ?c)))
    :effect (open ?c))

  (:action close-cupboard
    :parameters (?c - cupboard)
    :precondition (and (at ?c) (hand-empty) (open ?c))
    :effect (not (open ?c))))
