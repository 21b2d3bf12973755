; Fetch a treasure from a cave with a monster in it.
;
; What it shows: clauses (`or`) that tie what is smelt to what cannot be seen. A cell smells if and only if the
; monster is next to it; several smells together tell where it must be. Nobody enters a cell that may have it.
(define (domain wumpus)
  (:requirements :adl :contingent)

  (:types cell)

  (:predicates
    (at ?c - cell)
    (next-to ?c ?d - cell)
    (monster-in ?c - cell)         ; unknown at first
    (smelly ?c - cell)             ; unknown at first
    (treasure-in ?c - cell)        ; unknown at first
    (have-treasure))

  (:action move
    :parameters (?c ?d - cell)
    :precondition (and (at ?c) (next-to ?c ?d) (not (monster-in ?d)))
    :effect (and (not (at ?c)) (at ?d))
    :observe (smelly ?d))

  (:action dig
    :parameters (?c - cell)
    :precondition (at ?c)
    :observe (treasure-in ?c))

  (:action lift
    :parameters (?c - cell)
    :precondition (and (at ?c) (treasure-in ?c))
    :effect (and (have-treasure) (not (treasure-in ?c)))))
