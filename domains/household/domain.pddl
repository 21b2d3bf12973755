; A household robot tidies up, does the dishes and sweeps the floors.
;
; What it shows: action costs, quantifiers in conditions, effects and goals, conditional and universal effects.
;
; The robot has a tray for two things. Whoever comes in from outdoors with muddy wheels spoils the floor of every room
; on the way until the wheels are wiped on a doormat, so the order of the errands matters.
(define (domain household)
  (:requirements :adl :action-costs)

  (:types
    room thing - object
    dish toy - thing)

  (:predicates
    (door ?from ?to - room)        ; one can go from one to the other
    (outdoors ?r - room)
    (doormat ?r - room)
    (sink ?r - room)
    (home ?t - thing ?r - room)    ; where a thing belongs; there may be several such rooms

    (robot-in ?r - room)
    (muddy)                        ; the wheels of the robot
    (swept ?r - room)
    (in ?t - thing ?r - room)
    (carried ?t - thing)
    (tray-full)
    (dirty ?d - dish))

  (:functions
    (steps ?from ?to - room) - number
    (total-cost) - number)

  (:action go
    :parameters (?from ?to - room)
    :precondition (and (robot-in ?from) (door ?from ?to))
    :effect (and
      (not (robot-in ?from))
      (robot-in ?to)
      (when (outdoors ?to) (muddy))
      (when (and (muddy) (not (outdoors ?to))) (not (swept ?to)))
      (increase (total-cost) (steps ?from ?to))))

  (:action wipe-wheels
    :parameters (?r - room)
    :precondition (and (robot-in ?r) (doormat ?r) (muddy))
    :effect (and (not (muddy)) (increase (total-cost) 1)))

  ; The tray is full with the second thing: if there is one on it already.
  (:action take
    :parameters (?t - thing ?r - room)
    :precondition (and (robot-in ?r) (in ?t ?r) (not (tray-full)))
    :effect (and
      (not (in ?t ?r))
      (carried ?t)
      (when (exists (?other - thing) (carried ?other)) (tray-full))
      (increase (total-cost) 1)))

  (:action put
    :parameters (?t - thing ?r - room)
    :precondition (and (robot-in ?r) (carried ?t))
    :effect (and (not (carried ?t)) (not (tray-full)) (in ?t ?r) (increase (total-cost) 1)))

  ; Washes every dish that is at hand, in the room or on the tray.
  (:action wash-up
    :parameters (?r - room)
    :precondition (and (robot-in ?r) (sink ?r))
    :effect (and
      (forall (?d - dish) (when (or (in ?d ?r) (carried ?d)) (not (dirty ?d))))
      (increase (total-cost) 5)))

  ; Nothing that does not belong in the room may lie about.
  (:action sweep
    :parameters (?r - room)
    :precondition (and
      (robot-in ?r)
      (not (outdoors ?r))
      (not (muddy))
      (forall (?t - thing) (imply (in ?t ?r) (home ?t ?r))))
    :effect (and (swept ?r) (increase (total-cost) 3))))
