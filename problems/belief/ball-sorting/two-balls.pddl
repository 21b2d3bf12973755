; Two balls somewhere in 3 by 2 rooms; baskets in corners.
(define (problem ball-sorting-two-balls)
  (:domain ball-sorting)
  (:objects
    c11 c21 c31 c12 c22 c32 - room
    ball1 ball2 - ball red blue - colour)
  (:init
    (at c11) (hand-empty)
    (next-to c11 c21) (next-to c11 c12) (next-to c21 c31) (next-to c21 c11) (next-to c21 c22)
    (next-to c31 c21) (next-to c31 c32) (next-to c12 c22) (next-to c12 c11) (next-to c22 c32)
    (next-to c22 c12) (next-to c22 c21) (next-to c32 c22) (next-to c32 c31)
    (basket red c11) (basket blue c32)
    (oneof (in ball1 c11) (in ball1 c21) (in ball1 c31) (in ball1 c12) (in ball1 c22) (in ball1 c32))
    (oneof (has-colour ball1 red) (has-colour ball1 blue))
    (oneof (in ball2 c11) (in ball2 c21) (in ball2 c31) (in ball2 c12) (in ball2 c22) (in ball2 c32))
    (oneof (has-colour ball2 red) (has-colour ball2 blue)))
  (:goal (forall (?b - ball) (sorted ?b))))
