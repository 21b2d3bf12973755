; A ball has to lie on a table. It rolls off every table, unless it lies in a ring.
;
; As skills: navigating, picking and whatever goes to the floor or into the ring always succeed. The ball
; never stays on a bare table, whatever place-ball-on-table promises. A ring stays on a plain table everywhere
; and on the smooth one only where the table is sticky: where to put it is the parameter of place-ring-on-
; table.
(define (domain ball-ring)
  (:requirements :typing :conditional-effects)

  (:types table)

  (:predicates
    (beside-table ?t - table)  ; what the robot went to last
    (beside-ball)
    (beside-ring)
    (hand-empty)
    (holding-ball)             ; the ball alone
    (holding-ring)             ; and the ball, if it is in the ring
    (ball-on ?t - table)
    (ball-on-floor)
    (ball-in-ring)
    (ball-free)                ; not in the ring
    (ring-on ?t - table)
    (ring-on-floor))

  (:action navigate-to-table
    :parameters (?t - table)
    :effect (and (forall (?o - table) (not (beside-table ?o))) (not (beside-ball)) (not (beside-ring))
                 (beside-table ?t)))

  (:action navigate-to-ball
    :parameters ()
    :effect (and (forall (?o - table) (not (beside-table ?o))) (not (beside-ring)) (beside-ball)))

  (:action navigate-to-ring
    :parameters ()
    :effect (and (forall (?o - table) (not (beside-table ?o))) (not (beside-ball)) (beside-ring)))

  (:action pick-ball-from-table
    :parameters (?t - table)
    :precondition (and (beside-table ?t) (hand-empty) (ball-on ?t) (ball-free))
    :effect (and (not (hand-empty)) (not (ball-on ?t)) (holding-ball)))

  (:action pick-ball-from-floor
    :parameters ()
    :precondition (and (beside-ball) (hand-empty) (ball-on-floor))
    :effect (and (not (hand-empty)) (not (ball-on-floor)) (not (ball-in-ring)) (ball-free) (holding-ball)))

  (:action pick-ring-from-table
    :parameters (?t - table)
    :precondition (and (beside-table ?t) (hand-empty) (ring-on ?t) (ball-free))
    :effect (and (not (hand-empty)) (not (ring-on ?t)) (holding-ring)))

  (:action pick-ring-with-ball-from-table
    :parameters (?t - table)
    :precondition (and (beside-table ?t) (hand-empty) (ring-on ?t) (ball-on ?t) (ball-in-ring))
    :effect (and (not (hand-empty)) (not (ring-on ?t)) (not (ball-on ?t)) (holding-ring)))

  (:action pick-ring-from-floor
    :parameters ()
    :precondition (and (beside-ring) (hand-empty) (ring-on-floor) (ball-free))
    :effect (and (not (hand-empty)) (not (ring-on-floor)) (holding-ring)))

  (:action pick-ring-with-ball-from-floor
    :parameters ()
    :precondition (and (beside-ring) (hand-empty) (ring-on-floor) (ball-on-floor) (ball-in-ring))
    :effect (and (not (hand-empty)) (not (ring-on-floor)) (not (ball-on-floor)) (holding-ring)))

  (:action place-ball-on-table
    :parameters (?t - table)
    :precondition (and (beside-table ?t) (holding-ball))
    :effect (and (not (holding-ball)) (hand-empty) (ball-on ?t)))

  (:action place-ball-on-floor
    :parameters ()
    :precondition (holding-ball)
    :effect (and (not (holding-ball)) (not (beside-ball)) (hand-empty) (ball-on-floor)))

  (:action place-ball-in-ring-on-table
    :parameters (?t - table)
    :precondition (and (beside-ring) (ring-on ?t) (holding-ball))
    :effect (and (not (holding-ball)) (not (ball-free)) (hand-empty) (ball-in-ring) (ball-on ?t)))

  (:action place-ball-in-ring-on-floor
    :parameters ()
    :precondition (and (beside-ring) (ring-on-floor) (holding-ball))
    :effect (and (not (holding-ball)) (not (ball-free)) (hand-empty) (ball-in-ring) (ball-on-floor)))

  (:action place-ring-on-table
    :parameters (?t - table)
    :precondition (and (beside-table ?t) (holding-ring) (ball-free))
    :effect (and (not (holding-ring)) (hand-empty) (ring-on ?t)))

  (:action place-ring-on-floor
    :parameters ()
    :precondition (and (holding-ring) (ball-free))
    :effect (and (not (holding-ring)) (not (beside-ring)) (hand-empty) (ring-on-floor)))

  (:action place-ring-with-ball-on-floor
    :parameters ()
    :precondition (and (holding-ring) (ball-in-ring))
    :effect (and (not (holding-ring)) (not (beside-ring)) (not (beside-ball)) (hand-empty) (ring-on-floor)
                 (ball-on-floor))))
