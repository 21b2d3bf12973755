; Find balls, see their colours, bring each to the basket of its colour.
;
; What it shows: several kinds of uncertainty about one thing, found out one after the other: where a ball is, and
; which colour it has.
(define (domain ball-sorting)
  (:requirements :adl :contingent)

  (:types ball room colour)

  (:predicates
    (at ?r - room)
    (next-to ?r ?s - room)
    (in ?b - ball ?r - room)       ; unknown at first
    (has-colour ?b - ball ?c - colour)   ; unknown at first
    (basket ?c - colour ?r - room) ; where the basket for a colour stands
    (holding ?b - ball)
    (hand-empty)
    (sorted ?b - ball))

  (:action move
    :parameters (?r ?s - room)
    :precondition (and (at ?r) (next-to ?r ?s))
    :effect (and (not (at ?r)) (at ?s)))

  (:action look-for
    :parameters (?b - ball ?r - room)
    :precondition (at ?r)
    :observe (in ?b ?r))

  (:action pick
    :parameters (?b - ball ?r - room)
    :precondition (and (at ?r) (in ?b ?r) (hand-empty))
    :effect (and (holding ?b) (not (hand-empty)) (not (in ?b ?r))))

  (:action look-at
    :parameters (?b - ball ?c - colour)
    :precondition (holding ?b)
    :observe (has-colour ?b ?c))

  (:action put
    :parameters (?b - ball ?c - colour ?r - room)
    :precondition (and (at ?r) (basket ?c ?r) (holding ?b) (has-colour ?b ?c))
    :effect (and (sorted ?b) (hand-empty) (not (holding ?b)))))
