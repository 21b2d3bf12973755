; Whichever can the hand can lift is to stand in the region.
(define (problem weak-hand)
  (:domain weak-hand)
  (:objects can1 can2 - body goal - region p1 p2 - pose)
  (:init
    (graspable can1) (graspable can2)
    (placeable can1 goal) (placeable can2 goal)
    (pose-of can1 p1) (at can1 p1)
    (pose-of can2 p2) (at can2 p2)
    (hand-empty))
  (:goal (exists (?b - body) (in ?b goal))))
