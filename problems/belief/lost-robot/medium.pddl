; Rooms around two pillars. The map, with home at H:
;     .....
;     .#.#.
;     .H.#.
(define (problem lost-robot-medium)
  (:domain lost-robot)
  (:objects
    c11 c21 c31 c41 c51 c12 c32 c52 c13 c23 c33 c53 - cell
    north south west east - side)
  (:init
    (way c11 south c12) (way c11 east c21) (way c21 west c11) (way c21 east c31) (way c31 south c32)
    (way c31 west c21) (way c31 east c41) (way c41 west c31) (way c41 east c51) (way c51 south c52)
    (way c51 west c41) (way c12 north c11) (way c12 south c13) (way c32 north c31) (way c32 south c33)
    (way c52 north c51) (way c52 south c53) (way c13 north c12) (way c13 east c23) (way c23 west c13)
    (way c23 east c33) (way c33 north c32) (way c33 west c23) (way c53 north c52)
    (oneof (at c11) (at c21) (at c31) (at c41) (at c51) (at c12) (at c32) (at c52) (at c13) (at c23)
      (at c33) (at c53)))
  (:goal (at c23)))
