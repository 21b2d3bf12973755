; Clear out drawers without knowing what is in them, with a look for each thing.
;
; What it shows: explicit sensing. As drawer-cleaning, but an open drawer tells nothing by itself: the robot looks
; whether a thing is inside. What is known already need not be looked at.
(define (domain drawer-inspection)
  (:requirements :adl :derived-predicates :contingent)

  (:types drawer box - container container thing - object)

  (:predicates
    (inside ?t - thing ?c - container)   ; of drawers unknown at first
    (open ?d - drawer)
    (at ?c - container)                  ; where the robot stands
    (holding ?t - thing)
    (hand-empty)
    (empty ?d - drawer))

  (:derived (empty ?d - drawer)
    (forall (?t - thing) (not (inside ?t ?d))))

  (:action go
    :parameters (?from ?to - container)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action open-drawer
    :parameters (?d - drawer)
    :precondition (and (at ?d) (hand-empty) (not (open ?d)))
    :effect (open ?d))

  (:action close-drawer
    :parameters (?d - drawer)
    :precondition (and (at ?d) (hand-empty) (open ?d))
    :effect (not (open ?d)))

  (:action look-for
    :parameters (?t - thing ?d - drawer)
    :precondition (and (at ?d) (open ?d))
    :observe (inside ?t ?d))

  (:action take
    :parameters (?t - thing ?d - drawer)
    :precondition (and (at ?d) (open ?d) (hand-empty) (inside ?t ?d))
    :effect (and (holding ?t) (not (hand-empty)) (not (inside ?t ?d))))

  (:action drop
    :parameters (?t - thing ?b - box)
    :precondition (and (at ?b) (holding ?t))
    :effect (and (inside ?t ?b) (hand-empty) (not (holding ?t)))))
