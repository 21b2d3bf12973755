; A robot in a row of cells walks to the light in the last one and turns it on.
;
; As skills: walking always succeeds; how far to turn the dimmer is a parameter of turn-on and turn-off. What
; jump-to-light promises looks like a short cut, but the robot cannot jump.
(define (domain light-switch)
  (:requirements :typing :equality)

  (:types cell)

  (:predicates
    (adjacent ?c ?d - cell)
    (light-in ?c - cell)
    (robot-in ?c - cell)
    (light-on)
    (light-off))

  (:action move
    :parameters (?from ?to - cell)
    :precondition (and (robot-in ?from) (adjacent ?from ?to))
    :effect (and (not (robot-in ?from)) (robot-in ?to)))

  (:action turn-on
    :parameters (?c - cell)
    :precondition (and (robot-in ?c) (light-in ?c) (light-off))
    :effect (and (not (light-off)) (light-on)))

  (:action turn-off
    :parameters (?c - cell)
    :precondition (and (robot-in ?c) (light-in ?c) (light-on))
    :effect (and (not (light-on)) (light-off)))

  (:action jump-to-light
    :parameters (?from ?over ?to - cell)
    :precondition (and (robot-in ?from) (adjacent ?from ?over) (adjacent ?over ?to) (light-in ?to)
                       (not (= ?from ?to)))
    :effect (and (not (robot-in ?from)) (robot-in ?to))))
