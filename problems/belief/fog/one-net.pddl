; Six buoys; a net at the third.
(define (problem one-net)
  (:domain fog)
  (:objects b1 b2 b3 b4 b5 b6 - buoy n1 - net)
  (:init
    (next b1 b2) (next b2 b3) (next b3 b4) (next b4 b5) (next b5 b6) (next b6 b1)
    (makes b1 silence) (makes b2 bell) (makes b3 silence) (makes b4 horn) (makes b5 bell) (makes b6 silence)
    (set n1 b3))
  (:goal (and (hauled n1) (moored) (at b1))))
