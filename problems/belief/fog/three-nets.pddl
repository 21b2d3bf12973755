; Twelve buoys; the boat is lost anew after each of three nets.
(define (problem three-nets)
  (:domain fog)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 b9 b10 b11 b12 - buoy n1 n2 n3 - net)
  (:init
    (next b1 b2) (next b2 b3) (next b3 b4) (next b4 b5) (next b5 b6) (next b6 b7)
    (next b7 b8) (next b8 b9) (next b9 b10) (next b10 b11) (next b11 b12) (next b12 b1)
    (makes b1 silence) (makes b2 bell) (makes b3 silence) (makes b4 horn) (makes b5 bell) (makes b6 silence)
    (makes b7 silence) (makes b8 bell) (makes b9 bell) (makes b10 silence) (makes b11 horn) (makes b12 silence)
    (set n1 b3) (set n2 b8) (set n3 b12))
  (:goal (and (hauled n1) (hauled n2) (hauled n3) (moored) (at b1))))
