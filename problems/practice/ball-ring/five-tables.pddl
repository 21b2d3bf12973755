; The ball lies on a plain table and has to get onto the smooth one; the ring lies on the floor.
(define (problem ball-ring-five-tables)
  (:domain ball-ring)
  (:objects smooth-table table-1 table-2 table-3 table-4 - table)
  (:init (beside-table table-2) (hand-empty) (ball-on table-1) (ball-free) (ring-on-floor))
  (:goal (ball-on smooth-table)))
