(define (stream weak-hand)
  ; Whether the hand is strong enough; bound by the program.
  (:stream test-liftable
    :inputs (?b - body)
    :domain (graspable ?b)
    :certified (liftable ?b))

  ; The grasps of a body, in a fixed order.
  (:stream sample-grasp
    :inputs (?b - body)
    :domain (graspable ?b)
    :outputs (?g - grasp)
    :certified (grasp-of ?b ?g))

  ; Where a body can stand in a region.
  (:stream sample-placement
    :inputs (?b - body ?r - region)
    :domain (placeable ?b ?r)
    :outputs (?p - pose)
    :certified (and (pose-of ?b ?p) (supported ?b ?p ?r)))

  ; From where the robot is: to the body, close the hand, lift.
  (:stream plan-pick
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (pick-motion ?b ?p ?g ?m))

  ; Carry the body to the pose, let go, draw back.
  (:stream plan-place
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (place-motion ?b ?p ?g ?m)))
