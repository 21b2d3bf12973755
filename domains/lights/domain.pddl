; A grid of lamps: pressing one switches it and its neighbours; in the end all must be dark.
;
; What it shows: universal and conditional effects that read the state before the action. Each lamp near the pressed
; one is switched on if it was off and off if it was on, both "at once".
(define (domain lights)
  (:requirements :adl)

  (:types lamp - object)

  (:predicates
    (near ?a ?b - lamp)            ; pressing a switches b; a lamp is near itself
    (lit ?l - lamp))

  (:action press
    :parameters (?l - lamp)
    :precondition ()
    :effect (forall (?n - lamp)
      (and
        (when (and (near ?l ?n) (lit ?n)) (not (lit ?n)))
        (when (and (near ?l ?n) (not (lit ?n))) (lit ?n))))))
