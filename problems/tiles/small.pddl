; Two by two: three tiles.
(define (problem tiles-small)
  (:domain tiles)

  (:objects
    t1 t2 t3
    s11 s12 s21 s22)

  (:init
    ; the pieces
    (tile t1) (tile t2) (tile t3)
    ; the board
    (beside s11 s21) (beside s11 s12) (beside s12 s22) (beside s12 s11) (beside s21 s11)
    (beside s21 s22) (beside s22 s12) (beside s22 s21)
    ; the muddle
    (on t3 s11) (on t1 s12) (on t2 s21) (hole s22))

  (:goal
    (and
      (on t1 s11) (on t2 s12) (on t3 s21))))
