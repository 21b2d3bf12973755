; Blocks that an arm stacks. A block stands in a region, or on another block that stands at a pose.
(define (domain blocks)
  (:requirements :strips :typing :derived-predicates :existential-preconditions)
  (:types body region pose grasp motion)
  (:predicates
    (graspable ?b - body)
    (placeable ?b - body ?r - region)                        ; may be put there
    (stackable ?b ?c - body)                                 ; ?b may be put on ?c
    (site ?r - region)                                       ; a tower may be built there
    (pose-of ?b - body ?p - pose)
    (grasp-of ?b - body ?g - grasp)
    (supported ?b - body ?p - pose ?r - region)              ; standing there, it is in the region
    (stacked ?b - body ?p - pose ?c - body ?q - pose)        ; standing there, it is on ?c at ?q
    (pick-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (place-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (at ?b - body ?p - pose)
    (on-table ?b - body)
    (on ?b ?c - body)
    (clear ?b - body)
    (holding ?b - body ?g - grasp)
    (hand-empty)
    (sited ?b - body))

  (:derived (sited ?b - body)
    (exists (?r - region ?p - pose) (and (site ?r) (supported ?b ?p ?r) (at ?b ?p))))

  (:action pick
    :parameters (?b - body ?p - pose ?g - grasp ?m - motion)
    :precondition (and (pick-motion ?b ?p ?g ?m) (at ?b ?p) (on-table ?b) (clear ?b) (hand-empty))
    :effect (and (holding ?b ?g) (not (at ?b ?p)) (not (on-table ?b)) (not (hand-empty))))

  (:action unstack
    :parameters (?b - body ?p - pose ?c - body ?g - grasp ?m - motion)
    :precondition (and (pick-motion ?b ?p ?g ?m) (at ?b ?p) (on ?b ?c) (clear ?b) (hand-empty))
    :effect (and (holding ?b ?g) (clear ?c) (not (at ?b ?p)) (not (on ?b ?c)) (not (hand-empty))))

  (:action place
    :parameters (?b - body ?p - pose ?r - region ?g - grasp ?m - motion)
    :precondition (and (place-motion ?b ?p ?g ?m) (supported ?b ?p ?r) (holding ?b ?g))
    :effect (and (at ?b ?p) (on-table ?b) (hand-empty) (not (holding ?b ?g))))

  (:action stack
    :parameters (?b - body ?p - pose ?c - body ?q - pose ?g - grasp ?m - motion)
    :precondition (and (place-motion ?b ?p ?g ?m) (stacked ?b ?p ?c ?q) (holding ?b ?g) (at ?c ?q) (clear ?c))
    :effect (and (at ?b ?p) (on ?b ?c) (hand-empty) (not (holding ?b ?g)) (not (clear ?c)))))
