; The eight puzzle, shuffled by forty random slides from the goal (so it is solvable).
(define (problem tiles-medium)
  (:domain tiles)

  (:objects
    t1 t2 t3 t4 t5 t6 t7 t8
    s11 s12 s13 s21 s22 s23 s31 s32 s33)

  (:init
    ; the pieces
    (tile t1) (tile t2) (tile t3) (tile t4) (tile t5) (tile t6) (tile t7) (tile t8)
    ; the board
    (beside s11 s21) (beside s11 s12) (beside s12 s22) (beside s12 s11) (beside s12 s13)
    (beside s13 s23) (beside s13 s12) (beside s21 s11) (beside s21 s31) (beside s21 s22)
    (beside s22 s12) (beside s22 s32) (beside s22 s21) (beside s22 s23) (beside s23 s13)
    (beside s23 s33) (beside s23 s22) (beside s31 s21) (beside s31 s32) (beside s32 s22)
    (beside s32 s31) (beside s32 s33) (beside s33 s23) (beside s33 s32)
    ; the muddle
    (on t6 s11) (on t1 s12) (on t2 s13) (on t7 s21) (on t8 s22) (on t5 s23) (on t4 s31) (on t3 s32)
    (hole s33))

  (:goal
    (and
      (on t1 s11) (on t2 s12) (on t3 s13) (on t4 s21) (on t5 s22) (on t6 s23) (on t7 s31)
      (on t8 s32))))
