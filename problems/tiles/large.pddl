; The fifteen puzzle, shuffled by seventy random slides from the goal (so it is solvable).
(define (problem tiles-large)
  (:domain tiles)

  (:objects
    t1 t2 t3 t4 t5 t6 t7 t8 t9 t10 t11 t12 t13 t14 t15
    s11 s12 s13 s14 s21 s22 s23 s24 s31 s32 s33 s34 s41 s42 s43 s44)

  (:init
    ; the pieces
    (tile t1) (tile t2) (tile t3) (tile t4) (tile t5) (tile t6) (tile t7) (tile t8) (tile t9)
    (tile t10) (tile t11) (tile t12) (tile t13) (tile t14) (tile t15)
    ; the board
    (beside s11 s21) (beside s11 s12) (beside s12 s22) (beside s12 s11) (beside s12 s13)
    (beside s13 s23) (beside s13 s12) (beside s13 s14) (beside s14 s24) (beside s14 s13)
    (beside s21 s11) (beside s21 s31) (beside s21 s22) (beside s22 s12) (beside s22 s32)
    (beside s22 s21) (beside s22 s23) (beside s23 s13) (beside s23 s33) (beside s23 s22)
    (beside s23 s24) (beside s24 s14) (beside s24 s34) (beside s24 s23) (beside s31 s21)
    (beside s31 s41) (beside s31 s32) (beside s32 s22) (beside s32 s42) (beside s32 s31)
    (beside s32 s33) (beside s33 s23) (beside s33 s43) (beside s33 s32) (beside s33 s34)
    (beside s34 s24) (beside s34 s44) (beside s34 s33) (beside s41 s31) (beside s41 s42)
    (beside s42 s32) (beside s42 s41) (beside s42 s43) (beside s43 s33) (beside s43 s42)
    (beside s43 s44) (beside s44 s34) (beside s44 s43)
    ; the muddle
    (on t1 s11) (on t6 s12) (on t2 s13) (on t4 s14) (on t9 s21) (on t7 s23) (on t3 s24)
    (on t12 s31) (on t5 s32) (on t10 s33) (on t15 s34) (on t13 s41) (on t11 s42) (on t14 s43)
    (on t8 s44) (hole s22))

  (:goal
    (and
      (on t1 s11) (on t2 s12) (on t3 s13) (on t4 s14) (on t5 s21) (on t6 s22) (on t7 s23)
      (on t8 s24) (on t9 s31) (on t10 s32) (on t11 s33) (on t12 s34) (on t13 s41) (on t14 s42)
      (on t15 s43))))
