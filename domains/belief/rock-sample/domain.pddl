; A rover brings home samples of the good rocks.
;
; What it shows: sensing from a distance. Whether a rock is good is seen from everywhere in its range, so a rover that
; looks first need not go to those that are not.
(define (domain rock-sample)
  (:requirements :adl :contingent)

  (:types cell rock)

  (:predicates
    (at ?c - cell)
    (next-to ?c ?d - cell)
    (lies-in ?r - rock ?c - cell)
    (seen-from ?r - rock ?c - cell)
    (good ?r - rock)               ; unknown at first
    (sampled ?r - rock))

  (:action drive
    :parameters (?c ?d - cell)
    :precondition (and (at ?c) (next-to ?c ?d))
    :effect (and (not (at ?c)) (at ?d)))

  (:action check
    :parameters (?r - rock ?c - cell)
    :precondition (and (at ?c) (seen-from ?r ?c))
    :observe (good ?r))

  ; There is no room for what is worth nothing.
  (:action sample
    :parameters (?r - rock ?c - cell)
    :precondition (and (at ?c) (lies-in ?r ?c) (good ?r))
    :effect (sampled ?r)))
