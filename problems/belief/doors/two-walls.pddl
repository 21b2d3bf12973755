; Two walls of three doors.
(define (problem doors-two-walls)
  (:domain doors)
  (:objects
    a1 a2 a3 b1 b2 b3 - door)
  (:init
    (before a2)
    ; the doors of each wall in a row, straight across the halls
    (beside a1 a2) (beside a2 a1) (beside a2 a3) (beside a3 a2) (beside b1 b2) (beside b2 b1) (beside b2 b3)
    (beside b3 b2)
    (across a1 b1) (across a2 b2) (across a3 b3) (last b1) (last b2) (last b3)
    (oneof (unlocked a1) (unlocked a2) (unlocked a3))
    (oneof (unlocked b1) (unlocked b2) (unlocked b3)))
  (:goal (outside)))
