; Find one's own cup among cups that look alike.
;
; What it shows: things that only a close look tells apart. All cups have the same colour; whose one is stands on its
; base and can be read while it is held. Everything else about a cup is as uncertain as where it is, and what is
; known about one must not be taken for another.
(define (domain same-colour)
  (:requirements :adl :contingent)

  (:types cup place - object
          drawer tray - place)

  (:predicates
    (at ?p - place)
    (in ?c - cup ?p - place)       ; of drawers unknown at first
    (mine ?c - cup)                ; of exactly one cup, unknown at first
    (open ?d - drawer)
    (holding ?c - cup)
    (hand-empty)
    (served))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action open-drawer
    :parameters (?d - drawer)
    :precondition (and (at ?d) (hand-empty) (not (open ?d)))
    :effect (open ?d)
    :observe (forall (?c - cup) (in ?c ?d)))

  (:action look-inside
    :parameters (?d - drawer)
    :precondition (and (at ?d) (open ?d))
    :observe (forall (?c - cup) (in ?c ?d)))

  (:action close-drawer
    :parameters (?d - drawer)
    :precondition (and (at ?d) (hand-empty) (open ?d))
    :effect (not (open ?d)))

  (:action take
    :parameters (?c - cup ?d - drawer)
    :precondition (and (at ?d) (open ?d) (hand-empty) (in ?c ?d))
    :effect (and (holding ?c) (not (hand-empty)) (not (in ?c ?d))))

  (:action read-base
    :parameters (?c - cup)
    :precondition (holding ?c)
    :observe (mine ?c))

  (:action put-back
    :parameters (?c - cup ?d - drawer)
    :precondition (and (at ?d) (open ?d) (holding ?c))
    :effect (and (in ?c ?d) (hand-empty) (not (holding ?c))))

  ; Nobody is served somebody else's cup.
  (:action serve
    :parameters (?c - cup ?t - tray)
    :precondition (and (at ?t) (holding ?c) (mine ?c))
    :effect (and (in ?c ?t) (served) (hand-empty) (not (holding ?c)))))
