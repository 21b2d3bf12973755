; Three walls of four doors.
(define (problem doors-three-walls)
  (:domain doors)
  (:objects
    a1 a2 a3 a4 b1 b2 b3 b4 c1 c2 c3 c4 - door)
  (:init
    (before a3)
    ; the doors of each wall in a row, straight across the halls
    (beside a1 a2) (beside a2 a1) (beside a2 a3) (beside a3 a2) (beside a3 a4) (beside a4 a3) (beside b1 b2)
    (beside b2 b1) (beside b2 b3) (beside b3 b2) (beside b3 b4) (beside b4 b3) (beside c1 c2) (beside c2 c1)
    (beside c2 c3) (beside c3 c2) (beside c3 c4) (beside c4 c3)
    (across a1 b1) (across a2 b2) (across a3 b3) (across a4 b4) (across b1 c1) (across b2 c2) (across b3 c3)
    (across b4 c4) (last c1) (last c2) (last c3) (last c4)
    (oneof (unlocked a1) (unlocked a2) (unlocked a3) (unlocked a4))
    (oneof (unlocked b1) (unlocked b2) (unlocked b3) (unlocked b4))
    (oneof (unlocked c1) (unlocked c2) (unlocked c3) (unlocked c4)))
  (:goal (outside)))
