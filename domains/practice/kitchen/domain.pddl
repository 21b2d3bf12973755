; A robot with one hand puts dishes where they belong and sweeps crumbs into the bin that it pulls along.
;
; As skills: going and tipping crumbs out of the bin again always succeed; pick, place and sweep succeed with
; a probability that depends on their parameters. No task needs the drawer or the lamp: the drawer can be
; learned, the lamp has a loose contact and cannot.
(define (domain kitchen)
  (:requirements :typing :equality)

  (:types
    place thing crumbs - object
    dish brush - thing)

  (:predicates
    (at ?p - place)
    (hand-empty)
    (holding ?t - thing)
    (on ?t - thing ?p - place)
    (crumbs-on ?c - crumbs ?p - place)
    (in-bin ?c - crumbs)
    (drawer-at ?p - place)
    (drawer-open)
    (drawer-closed)
    (lamp-on)
    (lamp-off))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (at ?from) (not (= ?from ?to)))
    :effect (and (not (at ?from)) (at ?to)))

  (:action pick
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (on ?t ?p) (hand-empty))
    :effect (and (not (on ?t ?p)) (not (hand-empty)) (holding ?t)))

  (:action place
    :parameters (?t - thing ?p - place)
    :precondition (and (at ?p) (holding ?t))
    :effect (and (not (holding ?t)) (hand-empty) (on ?t ?p)))

  (:action sweep
    :parameters (?c - crumbs ?b - brush ?p - place)
    :precondition (and (at ?p) (crumbs-on ?c ?p) (holding ?b))
    :effect (and (not (crumbs-on ?c ?p)) (in-bin ?c)))

  (:action tip-out
    :parameters (?c - crumbs ?p - place)
    :precondition (and (at ?p) (in-bin ?c) (hand-empty))
    :effect (and (not (in-bin ?c)) (crumbs-on ?c ?p)))

  (:action open-drawer
    :parameters (?p - place)
    :precondition (and (at ?p) (drawer-at ?p) (drawer-closed) (hand-empty))
    :effect (and (not (drawer-closed)) (drawer-open)))

  (:action close-drawer
    :parameters (?p - place)
    :precondition (and (at ?p) (drawer-at ?p) (drawer-open) (hand-empty))
    :effect (and (not (drawer-open)) (drawer-closed)))

  (:action switch-lamp-on
    :parameters ()
    :precondition (lamp-off)
    :effect (and (not (lamp-off)) (lamp-on)))

  (:action switch-lamp-off
    :parameters ()
    :precondition (lamp-on)
    :effect (and (not (lamp-on)) (lamp-off))))
