; Blocks on a line: a gripper above a line of one dimension takes blocks from poses (numbers) and puts them into regions
; (intervals). The smallest domain with all that task and motion planning has: samples, inverse kinematics, motion,
; collisions that depend on where the other blocks are.
(define (domain line)
  (:requirements :typing :equality :negative-preconditions :existential-preconditions :derived-predicates :action-costs)
  (:types block region pose grasp configuration path)
  (:predicates
    (stackable ?b - block ?r - region)
    ; made by streams
    (pose ?b - block ?p - pose)
    (contained ?b - block ?p - pose ?r - region)
    (grasp ?b - block ?g - grasp)
    (kinematics ?b - block ?p - pose ?g - grasp ?q - configuration)
    (configuration ?q - configuration)
    (motion ?from - configuration ?t - path ?to - configuration)
    (apart ?b1 - block ?p1 - pose ?b2 - block ?p2 - pose)
    ; changed by actions
    (at-configuration ?q - configuration)
    (at-pose ?b - block ?p - pose)
    (holding ?b - block ?g - grasp)
    (hand-empty)
    (can-move)
    ; derived
    (in ?b - block ?r - region)
    (unsafe ?b - block ?p - pose))
  (:functions (total-cost) - number (distance ?from ?to - configuration) - number)

  (:derived (in ?b - block ?r - region)
    (exists (?p - pose) (and (at-pose ?b ?p) (contained ?b ?p ?r))))

  (:derived (unsafe ?b - block ?p - pose)
    (exists (?other - block ?there - pose)
      (and (at-pose ?other ?there) (not (= ?b ?other)) (not (apart ?b ?p ?other ?there)))))

  (:action move
    :parameters (?from - configuration ?t - path ?to - configuration)
    :precondition (and (can-move) (at-configuration ?from) (motion ?from ?t ?to))
    :effect (and (not (can-move)) (not (at-configuration ?from)) (at-configuration ?to)
                 (increase (total-cost) (distance ?from ?to))))

  (:action pick
    :parameters (?b - block ?p - pose ?g - grasp ?q - configuration)
    :precondition (and (hand-empty) (at-pose ?b ?p) (at-configuration ?q) (kinematics ?b ?p ?g ?q))
    :effect (and (holding ?b ?g) (can-move) (not (hand-empty)) (not (at-pose ?b ?p))
                 (increase (total-cost) 1)))

  (:action place
    :parameters (?b - block ?p - pose ?g - grasp ?q - configuration)
    :precondition (and (holding ?b ?g) (at-configuration ?q) (kinematics ?b ?p ?g ?q) (not (unsafe ?b ?p)))
    :effect (and (hand-empty) (can-move) (at-pose ?b ?p) (not (holding ?b ?g))
                 (increase (total-cost) 1))))
