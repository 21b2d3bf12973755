; Robots bring boxes to the dock of a warehouse and recharge on the way.
;
; What it shows: a type hierarchy, constants of the domain, several agents with different abilities.
;
; Carts carry parcels; forklifts carry parcels and pallets. Every drive takes the battery one level down; the only
; charger is the constant `charger`, and everything ends at the constant `dock`.
(define (domain warehouse)
  (:requirements :strips :typing :equality :negative-preconditions)

  (:types
    place robot box level - object
    station shelf - place
    cart forklift - robot
    parcel pallet - box)

  (:constants
    dock charger - station
    empty full - level)

  (:predicates
    (path ?from ?to - place)
    (below ?low ?high - level)     ; one drive takes a battery from high to low
    (battery ?r - robot ?l - level)
    (robot-at ?r - robot ?p - place)
    (box-at ?b - box ?p - place)
    (holds ?r - robot ?b - box)
    (loaded ?r - robot))

  (:action drive
    :parameters (?r - robot ?from ?to - place ?high ?low - level)
    :precondition (and (robot-at ?r ?from) (path ?from ?to) (battery ?r ?high) (below ?low ?high))
    :effect (and
      (not (robot-at ?r ?from)) (robot-at ?r ?to)
      (not (battery ?r ?high)) (battery ?r ?low)))

  (:action recharge
    :parameters (?r - robot ?now - level)
    :precondition (and (robot-at ?r charger) (battery ?r ?now) (not (= ?now full)))
    :effect (and (not (battery ?r ?now)) (battery ?r full)))

  (:action lift-parcel
    :parameters (?r - robot ?b - parcel ?p - place)
    :precondition (and (robot-at ?r ?p) (box-at ?b ?p) (not (loaded ?r)))
    :effect (and (not (box-at ?b ?p)) (holds ?r ?b) (loaded ?r)))

  (:action lift-pallet
    :parameters (?r - forklift ?b - pallet ?p - place)
    :precondition (and (robot-at ?r ?p) (box-at ?b ?p) (not (loaded ?r)))
    :effect (and (not (box-at ?b ?p)) (holds ?r ?b) (loaded ?r)))

  (:action set-down
    :parameters (?r - robot ?b - box ?p - place)
    :precondition (and (robot-at ?r ?p) (holds ?r ?b))
    :effect (and (box-at ?b ?p) (not (holds ?r ?b)) (not (loaded ?r)))))
