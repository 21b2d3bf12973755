; One ball somewhere in 2 by 2 rooms; baskets in corners.
(define (problem ball-sorting-one-ball)
  (:domain ball-sorting)
  (:objects
    c11 c21 c12 c22 - room
    ball1 - ball red blue - colour)
  (:init
    (at c11) (hand-empty)
    (next-to c11 c21) (next-to c11 c12) (next-to c21 c11) (next-to c21 c22) (next-to c12 c22)
    (next-to c12 c11) (next-to c22 c12) (next-to c22 c21)
    (basket red c11) (basket blue c22)
    (oneof (in ball1 c11) (in ball1 c21) (in ball1 c12) (in ball1 c22))
    (oneof (has-colour ball1 red) (has-colour ball1 blue)))
  (:goal (forall (?b - ball) (sorted ?b))))
