; Pipes have burst; repair them with the water off, and get the water back to every house.
;
; What it shows: derived predicates (axioms), recursive and negated, in preconditions and in the goal.
;
; Nobody says in an effect where the water is: it follows from the valves. A node is supplied if it is a reservoir or if
; an open, intact pipe joins it to a supplied node. Only pipes with a valve can be shut.
(define (domain water-network)
  (:requirements :adl :derived-predicates)

  (:types node pipe - object
          reservoir house junction - node)

  (:predicates
    (joins ?p - pipe ?a ?b - node)
    (valve ?p - pipe)
    (shut ?p - pipe)
    (burst ?p - pipe)
    (touches ?p - pipe ?n - node)  ; derived
    (supplied ?n - node)           ; derived
    (spilling ?p - pipe))          ; derived

  (:derived (touches ?p - pipe ?n - node)
    (exists (?m - node) (or (joins ?p ?n ?m) (joins ?p ?m ?n))))

  (:derived (supplied ?n - node)
    (or
      (exists (?r - reservoir) (= ?n ?r))
      (exists (?p - pipe ?m - node)
        (and (touches ?p ?n) (touches ?p ?m) (not (= ?n ?m))
             (not (shut ?p)) (not (burst ?p))
             (supplied ?m)))))

  (:derived (spilling ?p - pipe)
    (and (burst ?p) (not (shut ?p))
         (exists (?n - node) (and (touches ?p ?n) (supplied ?n)))))

  (:action shut-valve
    :parameters (?p - pipe)
    :precondition (and (valve ?p) (not (shut ?p)))
    :effect (shut ?p))

  ; Opening a valve on a burst pipe that would spill is not allowed.
  (:action open-valve
    :parameters (?p - pipe)
    :precondition (and
      (shut ?p)
      (imply (burst ?p) (not (exists (?n - node) (and (touches ?p ?n) (supplied ?n))))))
    :effect (not (shut ?p)))

  ; Needs no water at either end; nothing anywhere else may spill meanwhile, for there is only one crew.
  (:action repair
    :parameters (?p - pipe)
    :precondition (and
      (burst ?p)
      (forall (?n - node) (imply (touches ?p ?n) (not (supplied ?n))))
      (forall (?q - pipe) (not (spilling ?q))))
    :effect (not (burst ?p))))
