; Four walls of five doors.
(define (problem doors-four-walls)
  (:domain doors)
  (:objects
    a1 a2 a3 a4 a5 b1 b2 b3 b4 b5 c1 c2 c3 c4 c5 d1 d2 d3 d4 d5 - door)
  (:init
    (before a3)
    ; the doors of each wall in a row, straight across the halls
    (beside a1 a2) (beside a2 a1) (beside a2 a3) (beside a3 a2) (beside a3 a4) (beside a4 a3) (beside a4 a5)
    (beside a5 a4) (beside b1 b2) (beside b2 b1) (beside b2 b3) (beside b3 b2) (beside b3 b4) (beside b4 b3)
    (beside b4 b5) (beside b5 b4) (beside c1 c2) (beside c2 c1) (beside c2 c3) (beside c3 c2) (beside c3 c4)
    (beside c4 c3) (beside c4 c5) (beside c5 c4) (beside d1 d2) (beside d2 d1) (beside d2 d3) (beside d3 d2)
    (beside d3 d4) (beside d4 d3) (beside d4 d5) (beside d5 d4)
    (across a1 b1) (across a2 b2) (across a3 b3) (across a4 b4) (across a5 b5) (across b1 c1) (across b2 c2)
    (across b3 c3) (across b4 c4) (across b5 c5) (across c1 d1) (across c2 d2) (across c3 d3) (across c4 d4)
    (across c5 d5) (last d1) (last d2) (last d3) (last d4) (last d5)
    (oneof (unlocked a1) (unlocked a2) (unlocked a3) (unlocked a4) (unlocked a5))
    (oneof (unlocked b1) (unlocked b2) (unlocked b3) (unlocked b4) (unlocked b5))
    (oneof (unlocked c1) (unlocked c2) (unlocked c3) (unlocked c4) (unlocked c5))
    (oneof (unlocked d1) (unlocked d2) (unlocked d3) (unlocked d4) (unlocked d5)))
  (:goal (outside)))
