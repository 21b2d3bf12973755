; Walk through halls whose doors are locked but for one.
;
; What it shows: exactly one of several facts holds (`oneof`). Who has found all doors of a wall locked but one need
; not try the last.
(define (domain doors)
  (:requirements :adl :contingent)

  (:types door)

  (:predicates
    (before ?d - door)             ; where the robot stands
    (beside ?d ?e - door)          ; of one wall, neighbours
    (across ?d ?e - door)          ; from door d straight through the hall is door e
    (unlocked ?d - door)           ; unknown at first
    (outside)
    (last ?d - door))              ; of the last wall

  (:action walk
    :parameters (?d ?e - door)
    :precondition (and (before ?d) (beside ?d ?e))
    :effect (and (not (before ?d)) (before ?e)))

  (:action try-handle
    :parameters (?d - door)
    :precondition (before ?d)
    :observe (unlocked ?d))

  (:action pass
    :parameters (?d ?e - door)
    :precondition (and (before ?d) (unlocked ?d) (across ?d ?e))
    :effect (and (not (before ?d)) (before ?e)))

  (:action leave
    :parameters (?d - door)
    :precondition (and (before ?d) (unlocked ?d) (last ?d))
    :effect (and (not (before ?d)) (outside))))
