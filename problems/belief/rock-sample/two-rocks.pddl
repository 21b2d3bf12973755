; Two rocks in 3 by 3 cells, seen from 1 cell away; home is the corner opposite.
(define (problem rock-sample-two-rocks)
  (:domain rock-sample)
  (:objects
    c11 c21 c31 c12 c22 c32 c13 c23 c33 - cell
    rock1 rock2 - rock)
  (:init
    (at c11)
    (next-to c11 c21) (next-to c11 c12) (next-to c21 c31) (next-to c21 c11) (next-to c21 c22)
    (next-to c31 c21) (next-to c31 c32) (next-to c12 c22) (next-to c12 c13) (next-to c12 c11)
    (next-to c22 c32) (next-to c22 c12) (next-to c22 c23) (next-to c22 c21) (next-to c32 c22)
    (next-to c32 c33) (next-to c32 c31) (next-to c13 c23) (next-to c13 c12) (next-to c23 c33)
    (next-to c23 c13) (next-to c23 c22) (next-to c33 c23) (next-to c33 c32)
    (lies-in rock1 c31) (lies-in rock2 c13)
    (seen-from rock1 c21) (seen-from rock1 c31) (seen-from rock1 c32) (seen-from rock2 c12)
    (seen-from rock2 c13) (seen-from rock2 c23)
    (unknown (good rock1)) (unknown (good rock2)))
  (:goal (and (at c33) (forall (?r - rock) (or (sampled ?r) (not (good ?r)))))))
