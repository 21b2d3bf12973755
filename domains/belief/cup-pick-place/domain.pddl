; Put cups into a box. Everything that matters is known.
;
; What it shows: an uncertain fact that does not matter. Whether a cup is wet can be found out, but nothing asks
; for it, so a planner that gathers information only where it is needed does not look.
(define (domain cup-pick-place)
  (:requirements :adl :contingent)

  (:types cup box - thing thing place - object)

  (:predicates
    (on ?c - cup ?p - place)
    (inside ?c - cup ?b - box)
    (in-view ?t - thing)       ; of the camera in the hand
    (wet ?c - cup)             ; unknown at first
    (holding ?c - cup)
    (hand-empty))

  ; Where the camera turns to one thing, it sees no other any more.
  (:action view
    :parameters (?t - thing)
    :precondition (not (in-view ?t))
    :effect (and
      (in-view ?t)
      (forall (?other - thing) (when (not (= ?other ?t)) (not (in-view ?other))))))

  (:action inspect
    :parameters (?c - cup)
    :precondition (in-view ?c)
    :observe (wet ?c))

  (:action pick
    :parameters (?c - cup ?p - place)
    :precondition (and (in-view ?c) (hand-empty) (on ?c ?p))
    :effect (and (holding ?c) (not (hand-empty)) (not (on ?c ?p))))

  (:action drop
    :parameters (?c - cup ?b - box)
    :precondition (holding ?c)
    :effect (and (inside ?c ?b) (hand-empty) (not (holding ?c)))))
