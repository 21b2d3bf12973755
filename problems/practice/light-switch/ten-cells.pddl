; Ten cells; the robot is in the first, the light in the last.
(define (problem light-switch-10)
  (:domain light-switch)
  (:objects
    c0 c1 c2 c3 c4 c5 c6 c7 c8 c9 - cell)
  (:init (robot-in c0) (light-off) (light-in c9)
    (adjacent c0 c1) (adjacent c1 c0) (adjacent c1 c2) (adjacent c2 c1)
    (adjacent c2 c3) (adjacent c3 c2) (adjacent c3 c4) (adjacent c4 c3)
    (adjacent c4 c5) (adjacent c5 c4) (adjacent c5 c6) (adjacent c6 c5)
    (adjacent c6 c7) (adjacent c7 c6) (adjacent c7 c8) (adjacent c8 c7)
    (adjacent c8 c9) (adjacent c9 c8))
  (:goal (light-on)))
