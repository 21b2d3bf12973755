; A fishing boat in the fog, on a ring of buoys. Bells, horns and silence tell which buoy it may be at; while a net
; is hauled in, the boat drifts, and may be anywhere afterwards.
(define (domain fog)
  (:requirements :strips :typing :conditional-effects :translation)
  (:types buoy net sound)
  (:constants bell horn silence - sound)
  (:predicates
    (next ?b ?c - buoy)
    (makes ?b - buoy ?s - sound)
    (at ?b - buoy)               ; where the boat is: one buoy at any time
    (heard ?s - sound)           ; what is heard there
    (set ?n - net ?b - buoy)     ; the net hangs at this buoy
    (hauled ?n - net)
    (moored))

  (:variable position (forall (?b - buoy) (at ?b)))
  (:obs-variable hearing (forall (?s - sound) (heard ?s)))

  ; After every action the ears are open.
  (:default-sensing-model
    (forall (?b - buoy ?s - sound) (when (and (at ?b) (makes ?b ?s)) (heard ?s))))

  (:action listen
    :parameters ())

  (:action sail
    :parameters ()
    :effect (forall (?b ?c - buoy)
      (when (and (at ?b) (next ?b ?c)) (and (not (at ?b)) (at ?c)))))

  (:action haul
    :parameters (?n - net ?b - buoy)
    :precondition (and (at ?b) (set ?n ?b))
    :effect (and (hauled ?n) (unknown (at ?b))))

  ; Nobody moors where a bell rings: there is a rock.
  (:action moor
    :parameters (?b - buoy)
    :precondition (and (at ?b) (heard silence))
    :effect (moored)))
