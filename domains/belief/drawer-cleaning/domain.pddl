; Clear out drawers without knowing what is in them.
;
; What it shows: sensing by the way. Opening a drawer shows what lies in it: the action has an effect and a reading.
; That a drawer is empty is derived: it is known as soon as of every thing it is known that it is not inside.
(define (domain drawer-cleaning)
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
    :effect (open ?d)
    :observe (forall (?t - thing) (inside ?t ?d)))

  ; For those who do not trust the first glance.
  (:action look-inside
    :parameters (?d - drawer)
    :precondition (and (at ?d) (open ?d))
    :observe (forall (?t - thing) (inside ?t ?d)))

  (:action close-drawer
    :parameters (?d - drawer)
    :precondition (and (at ?d) (hand-empty) (open ?d))
    :effect (not (open ?d)))

  (:action take
    :parameters (?t - thing ?d - drawer)
    :precondition (and (at ?d) (open ?d) (hand-empty) (inside ?t ?d))
    :effect (and (holding ?t) (not (hand-empty)) (not (inside ?t ?d))))

  (:action drop
    :parameters (?t - thing ?b - box)
    :precondition (and (at ?b) (holding ?t))
    :effect (and (inside ?t ?b) (hand-empty) (not (holding ?t)))))
