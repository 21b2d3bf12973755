; Two cans change regions.
(define (problem swap)
  (:domain configurations)
  (:objects can1 can2 - body left right middle - region p1 p2 - pose start - configuration)
  (:init
    (graspable can1) (graspable can2)
    (placeable can1 right) (placeable can1 middle) (placeable can2 left) (placeable can2 middle)
    (pose-of can1 p1) (at can1 p1)
    (pose-of can2 p2) (at can2 p2)
    (configuration-of start) (at-configuration start)
    (hand-empty)
    (= (total-cost) 0))
  (:goal (and (in can1 right) (in can2 left)))
  (:metric minimize (total-cost)))
