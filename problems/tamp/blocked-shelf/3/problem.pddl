; A target behind 3 blockers in a cell of a shelf; it has to go to the table on the right.
(define (problem blocked-shelf-3-1)
  (:domain pick-place)
  (:objects left right - region
            target can1 can2 can3 - body
            p-target p-can1 p-can2 p-can3 - pose)
  (:init (hand-empty)
         (graspable target) (pose-of target p-target) (at target p-target)
         (placeable target left) (placeable target right)
         (graspable can1) (pose-of can1 p-can1) (at can1 p-can1)
         (placeable can1 left) (placeable can1 right)
         (graspable can2) (pose-of can2 p-can2) (at can2 p-can2)
         (placeable can2 left) (placeable can2 right)
         (graspable can3) (pose-of can3 p-can3) (at can3 p-can3)
         (placeable can3 left) (placeable can3 right))
  (:goal (and (in target right))))
