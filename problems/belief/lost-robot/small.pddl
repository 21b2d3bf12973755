; A corridor with two dead ends. The map, with home at H:
;     ....
;     H##.
(define (problem lost-robot-small)
  (:domain lost-robot)
  (:objects
    c11 c21 c31 c41 c12 c42 - cell
    north south west east - side)
  (:init
    (way c11 south c12) (way c11 east c21) (way c21 west c11) (way c21 east c31) (way c31 west c21)
    (way c31 east c41) (way c41 south c42) (way c41 west c31) (way c12 north c11) (way c42 north c41)
    (oneof (at c11) (at c21) (at c31) (at c41) (at c12) (at c42)))
  (:goal (at c12)))
