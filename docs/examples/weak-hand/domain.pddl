; Picking and placing with an arm that is not strong.
(define (domain weak-hand)
  (:requirements :strips :typing :derived-predicates :existential-preconditions)
  (:types body region pose grasp motion)
  (:predicates
    (graspable ?b - body)
    (liftable ?b - body)
    (placeable ?b - body ?r - region)                        ; may be put there
    (pose-of ?b - body ?p - pose)
    (grasp-of ?b - body ?g - grasp)
    (supported ?b - body ?p - pose ?r - region)              ; standing there, it is in the region
    (pick-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (place-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (at ?b - body ?p - pose)
    (holding ?b - body ?g - grasp)
    (hand-empty)
    (in ?b - body ?r - region))

  (:derived (in ?b - body ?r - region)
    (exists (?p - pose) (and (supported ?b ?p ?r) (at ?b ?p))))

  (:action pick
    :parameters (?b - body ?p - pose ?g - grasp ?m - motion)
    :precondition (and (liftable ?b) (pick-motion ?b ?p ?g ?m) (at ?b ?p) (hand-empty))
    :effect (and (holding ?b ?g) (not (at ?b ?p)) (not (hand-empty))))

  (:action place
    :parameters (?b - body ?p - pose ?g - grasp ?m - motion)
    :precondition (and (place-motion ?b ?p ?g ?m) (holding ?b ?g))
    :effect (and (at ?b ?p) (hand-empty) (not (holding ?b ?g)))))
