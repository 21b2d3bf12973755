; Bring the empty cups to the bin and leave the full ones alone.
;
; What it shows: a look that needs preparation. From the front a cup does not show whether there is something in it: the
; camera has to be above. Lifting a full cup spills it, so it must be known to be empty before it is picked.
(define (domain cup-removal)
  (:requirements :adl :contingent)

  (:types cup place - object
          table bin - place)

  (:predicates
    (at ?p - place)                ; where the robot stands
    (on ?c - cup ?p - place)
    (full ?c - cup)                ; unknown at first
    (above ?c - cup)               ; the camera is over the cup
    (camera-down)                  ; it is at rest
    (holding ?c - cup)
    (hand-empty))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (camera-down) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action raise-camera
    :parameters (?c - cup ?t - table)
    :precondition (and (at ?t) (on ?c ?t) (hand-empty) (camera-down))
    :effect (and (above ?c) (not (camera-down))))

  (:action lower-camera
    :parameters (?c - cup)
    :precondition (above ?c)
    :effect (and (camera-down) (not (above ?c))))

  (:action look-into
    :parameters (?c - cup)
    :precondition (above ?c)
    :observe (full ?c))

  (:action pick
    :parameters (?c - cup ?t - table)
    :precondition (and (at ?t) (on ?c ?t) (hand-empty) (camera-down) (not (full ?c)))
    :effect (and (holding ?c) (not (hand-empty)) (not (on ?c ?t))))

  (:action drop
    :parameters (?c - cup ?b - bin)
    :precondition (and (at ?b) (holding ?c))
    :effect (and (on ?c ?b) (hand-empty) (not (holding ?c)))))
