; The towers of Hanoi with an arm. Where discs can be is known: a pose a peg and level; grasps and motions are
; continuous.
(define (domain hanoi)
  (:requirements :strips :typing)
  (:types body pose grasp motion)
  (:predicates
    (smaller ?b ?c - body)
    (bottom ?p - pose)                 ; on the ground
    (above ?p ?q - pose)               ; the next pose over ?q
    (graspable ?b - body)
    (pose-of ?b - body ?p - pose)
    (grasp-of ?b - body ?g - grasp)
    (pick-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (place-motion ?b - body ?p - pose ?g - grasp ?m - motion)
    (at ?b - body ?p - pose)
    (empty ?p - pose)
    (holding ?b - body ?g - grasp)
    (hand-empty))

  (:action pick
    :parameters (?b - body ?p ?over - pose ?g - grasp ?m - motion)
    :precondition (and (pick-motion ?b ?p ?g ?m) (at ?b ?p) (above ?over ?p) (empty ?over) (hand-empty))
    :effect (and (holding ?b ?g) (empty ?p) (not (at ?b ?p)) (not (hand-empty))))

  (:action place
    :parameters (?b - body ?p - pose ?g - grasp ?m - motion)
    :precondition (and (place-motion ?b ?p ?g ?m) (holding ?b ?g) (bottom ?p) (empty ?p))
    :effect (and (at ?b ?p) (hand-empty) (not (holding ?b ?g)) (not (empty ?p))))

  (:action stack
    :parameters (?b - body ?p - pose ?c - body ?q - pose ?g - grasp ?m - motion)
    :precondition (and (place-motion ?b ?p ?g ?m) (holding ?b ?g) (above ?p ?q) (at ?c ?q) (smaller ?b ?c)
                       (empty ?p))
    :effect (and (at ?b ?p) (hand-empty) (not (holding ?b ?g)) (not (empty ?p)))))
