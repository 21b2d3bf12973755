; Picking and placing where the robot's configuration is part of the state: moving is an action of its own, and costs
; what its path is long.
(define (domain configurations)
  (:requirements :strips :typing :derived-predicates :existential-preconditions :action-costs)
  (:types body region pose grasp configuration motion)
  (:predicates
    (graspable ?b - body)
    (placeable ?b - body ?r - region)                        ; may be put there
    (pose-of ?b - body ?p - pose)
    (grasp-of ?b - body ?g - grasp)
    (configuration-of ?q - configuration)
    (supported ?b - body ?p - pose ?r - region)              ; standing there, it is in the region
    (before ?b - body ?p - pose ?g - grasp ?q - configuration)
    (free-motion ?q1 ?q2 - configuration ?m - motion)
    (holding-motion ?q1 ?q2 - configuration ?b - body ?g - grasp ?m - motion)
    (grasp-motion ?b - body ?p - pose ?g - grasp ?q - configuration ?m - motion)
    (release-motion ?b - body ?p - pose ?g - grasp ?q - configuration ?m - motion)
    (at ?b - body ?p - pose)
    (at-configuration ?q - configuration)
    (holding ?b - body ?g - grasp)
    (hand-empty)
    (in ?b - body ?r - region))
  (:functions
    (motion-length ?m - motion)
    (total-cost))

  (:derived (in ?b - body ?r - region)
    (exists (?p - pose) (and (supported ?b ?p ?r) (at ?b ?p))))

  (:action move
    :parameters (?q1 ?q2 - configuration ?m - motion)
    :precondition (and (free-motion ?q1 ?q2 ?m) (at-configuration ?q1) (hand-empty))
    :effect (and (at-configuration ?q2) (not (at-configuration ?q1)) (increase (total-cost) (motion-length ?m))))

  (:action carry
    :parameters (?b - body ?g - grasp ?q1 ?q2 - configuration ?m - motion)
    :precondition (and (holding-motion ?q1 ?q2 ?b ?g ?m) (at-configuration ?q1) (holding ?b ?g))
    :effect (and (at-configuration ?q2) (not (at-configuration ?q1)) (increase (total-cost) (motion-length ?m))))

  (:action pick
    :parameters (?b - body ?p - pose ?g - grasp ?q - configuration ?m - motion)
    :precondition (and (grasp-motion ?b ?p ?g ?q ?m) (at ?b ?p) (at-configuration ?q) (hand-empty))
    :effect (and (holding ?b ?g) (not (at ?b ?p)) (not (hand-empty)) (increase (total-cost) (motion-length ?m))))

  (:action place
    :parameters (?b - body ?p - pose ?g - grasp ?q - configuration ?m - motion)
    :precondition (and (release-motion ?b ?p ?g ?q ?m) (holding ?b ?g) (at-configuration ?q))
    :effect (and (at ?b ?p) (hand-empty) (not (holding ?b ?g)) (increase (total-cost) (motion-length ?m)))))
