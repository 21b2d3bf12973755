; A target behind 2 blockers, which must stand where they stood at first.
(define (problem non-monotonic-2-1)
  (:domain pick-place)
  (:objects left right behind - region
            target can1 can2 - body
            p-target p-can1 p-can2 - pose)
  (:init (hand-empty)
         (graspable target) (pose-of target p-target) (at target p-target)
         (placeable target left) (placeable target right)
         (placeable target behind)
         (graspable can1) (pose-of can1 p-can1) (at can1 p-can1)
         (placeable can1 left) (placeable can1 right)
         (placeable can1 behind)
         (graspable can2) (pose-of can2 p-can2) (at can2 p-can2)
         (placeable can2 left) (placeable can2 right)
         (placeable can2 behind))
  (:goal (and (in target right)
              (at can1 p-can1)
              (at can2 p-can2))))
