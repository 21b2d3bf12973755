; A robot that does not know where it is finds its way home.
;
; What it shows: actions that do something whatever the place is (conditional effects under uncertainty), and readings
; that depend on the place: the robot can feel on which sides of it there are walls.
(define (domain lost-robot)
  (:requirements :adl :contingent)

  (:types cell side)

  (:predicates
    (at ?c - cell)                 ; unknown at first
    (way ?c - cell ?s - side ?d - cell)
    (wall ?s - side)               ; what the bumpers say; unknown at first
    (felt))                        ; here

  ; The bumpers are set as the walls are, and read.
  (:action feel
    :parameters ()
    :effect (and
      (felt)
      (forall (?c - cell ?s - side)
        (and
          (when (and (at ?c) (exists (?d - cell) (way ?c ?s ?d))) (not (wall ?s)))
          (when (and (at ?c) (not (exists (?d - cell) (way ?c ?s ?d)))) (wall ?s)))))
    :observe (forall (?s - side) (wall ?s)))

  ; It must not run into a wall, so it has to know first.
  (:action roll
    :parameters (?s - side)
    :precondition (and (felt) (not (wall ?s)))
    :effect (and
      (not (felt))
      (forall (?c ?d - cell)
        (when (and (at ?c) (way ?c ?s ?d)) (and (not (at ?c)) (at ?d)))))))
