; 4 sticks have to be sorted by colour.
(define (problem clutter-4-1-infeasible)
  (:domain pick-place)
  (:objects red green blue yellow - region
            stick1 stick2 stick3 stick4 - body
            p-stick1 p-stick2 p-stick3 p-stick4 - pose)
  (:init (hand-empty)
         (graspable stick1) (pose-of stick1 p-stick1) (at stick1 p-stick1)
         (placeable stick1 red)
         (graspable stick2) (pose-of stick2 p-stick2) (at stick2 p-stick2)
         (placeable stick2 green)
         (graspable stick3) (pose-of stick3 p-stick3) (at stick3 p-stick3)
         (placeable stick3 blue)
         (graspable stick4) (pose-of stick4 p-stick4) (at stick4 p-stick4)
         (placeable stick4 yellow))
  (:goal (and (in stick1 red)
              (in stick2 green)
              (in stick3 blue)
              (in stick4 yellow))))
