; Two boxes on a desk: the first is light, the second is heavy.
(define (problem weighing-two-boxes)
  (:domain weighing)
  (:objects
    desk - table balance - scale bin - light-bin shelf locker chest - cupboard
    box1 box2 - box)
  (:init (at desk) (hand-empty) (free balance) (on box1 desk) (on box2 desk))
  (:goal (and (on box1 bin) (weighed box2))))
