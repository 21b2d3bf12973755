; The cup belongs on the shelf, and the table has to be free of crumbs.
(define (problem kitchen-cup-and-crumbs)
  (:domain kitchen)
  (:objects
    counter table shelf sink floor - place
    cup plate - dish
    brush - brush
    bread-crumbs coffee-grounds - crumbs)
  (:init
    (at floor) (hand-empty) (on cup counter) (on plate sink) (on brush floor)
    (crumbs-on bread-crumbs table) (crumbs-on coffee-grounds counter)
    (drawer-at counter) (drawer-closed) (lamp-off))
  (:goal (and (on cup shelf) (in-bin bread-crumbs))))
