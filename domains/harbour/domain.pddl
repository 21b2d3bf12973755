; Cranes, ships and drivers move containers and cars around a harbour.
;
; What it shows: `either` types. A crane lifts "either a container or a car" and sets it down on "either a quay or a
; ship", although containers and cars (or quays and ships) have no common supertype besides `object`.
(define (domain harbour)
  (:requirements :strips :typing :negative-preconditions)

  (:types container car crane quay ship driver - object)

  (:predicates
    (reaches ?c - crane ?p - quay)
    (street ?from ?to - quay)
    (moored ?s - ship ?p - quay)
    (berth-free ?p - quay)
    (stands ?x - (either container car) ?p - (either quay ship))
    (hangs ?x - (either container car) ?c - crane)
    (busy ?c - crane)
    (waits ?d - driver ?p - quay)
    (drives ?d - driver ?x - car)
    (occupied ?x - car))

  (:action lift
    :parameters (?c - crane ?x - (either container car) ?q - quay)
    :precondition (and (reaches ?c ?q) (stands ?x ?q) (not (busy ?c)))
    :effect (and (not (stands ?x ?q)) (hangs ?x ?c) (busy ?c)))

  (:action lift-from-ship
    :parameters (?c - crane ?x - (either container car) ?s - ship ?q - quay)
    :precondition (and (reaches ?c ?q) (moored ?s ?q) (stands ?x ?s) (not (busy ?c)))
    :effect (and (not (stands ?x ?s)) (hangs ?x ?c) (busy ?c)))

  (:action lower
    :parameters (?c - crane ?x - (either container car) ?q - quay)
    :precondition (and (reaches ?c ?q) (hangs ?x ?c))
    :effect (and (stands ?x ?q) (not (hangs ?x ?c)) (not (busy ?c))))

  (:action lower-onto-ship
    :parameters (?c - crane ?x - (either container car) ?s - ship ?q - quay)
    :precondition (and (reaches ?c ?q) (moored ?s ?q) (hangs ?x ?c))
    :effect (and (stands ?x ?s) (not (hangs ?x ?c)) (not (busy ?c))))

  (:action sail
    :parameters (?s - ship ?from ?to - quay)
    :precondition (and (moored ?s ?from) (berth-free ?to))
    :effect (and
      (not (moored ?s ?from)) (moored ?s ?to)
      (not (berth-free ?to)) (berth-free ?from)))

  (:action get-in
    :parameters (?d - driver ?x - car ?q - quay)
    :precondition (and (waits ?d ?q) (stands ?x ?q) (not (occupied ?x)))
    :effect (and (not (waits ?d ?q)) (drives ?d ?x) (occupied ?x)))

  (:action get-out
    :parameters (?d - driver ?x - car ?q - quay)
    :precondition (and (drives ?d ?x) (stands ?x ?q))
    :effect (and (waits ?d ?q) (not (drives ?d ?x)) (not (occupied ?x))))

  (:action walk
    :parameters (?d - driver ?from ?to - quay)
    :precondition (and (waits ?d ?from) (street ?from ?to))
    :effect (and (not (waits ?d ?from)) (waits ?d ?to)))

  (:action drive
    :parameters (?d - driver ?x - car ?from ?to - quay)
    :precondition (and (drives ?d ?x) (stands ?x ?from) (street ?from ?to))
    :effect (and (not (stands ?x ?from)) (stands ?x ?to))))
