(define (stream blocks)
  ; The grasps of a block, in a fixed order.
  (:stream sample-grasp
    :inputs (?b - body)
    :domain (graspable ?b)
    :outputs (?g - grasp)
    :certified (grasp-of ?b ?g))

  ; Where a block can stand in a region.
  (:stream sample-placement
    :inputs (?b - body ?r - region)
    :domain (placeable ?b ?r)
    :outputs (?p - pose)
    :certified (and (pose-of ?b ?p) (supported ?b ?p ?r)))

  ; The pose of a block on another.
  (:stream sample-stacking
    :inputs (?b ?c - body ?q - pose)
    :domain (and (stackable ?b ?c) (pose-of ?c ?q))
    :outputs (?p - pose)
    :certified (and (pose-of ?b ?p) (stacked ?b ?p ?c ?q)))

  ; From where the robot is: to the block, close the hand, lift.
  (:stream plan-pick
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (pick-motion ?b ?p ?g ?m))

  ; Carry the block to the pose, let go, draw back.
  (:stream plan-place
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (place-motion ?b ?p ?g ?m)))
