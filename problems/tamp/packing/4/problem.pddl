; 4 pieces have to be packed into a tray.
(define (problem packing-4-1)
  (:domain pick-place)
  (:objects tray - region
            piece1 piece2 piece3 piece4 - body
            p-piece1 p-piece2 p-piece3 p-piece4 - pose)
  (:init (hand-empty)
         (graspable piece1) (pose-of piece1 p-piece1) (at piece1 p-piece1)
         (placeable piece1 tray)
         (graspable piece2) (pose-of piece2 p-piece2) (at piece2 p-piece2)
         (placeable piece2 tray)
         (graspable piece3) (pose-of piece3 p-piece3) (at piece3 p-piece3)
         (placeable piece3 tray)
         (graspable piece4) (pose-of piece4 p-piece4) (at piece4 p-piece4)
         (placeable piece4 tray))
  (:goal (and (in piece1 tray)
              (in piece2 tray)
              (in piece3 tray)
              (in piece4 tray))))
