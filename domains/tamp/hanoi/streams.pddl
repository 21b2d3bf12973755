(define (stream hanoi)
  ; The grasps of a disc, in a fixed order.
  (:stream sample-grasp
    :inputs (?b - body)
    :domain (graspable ?b)
    :outputs (?g - grasp)
    :certified (grasp-of ?b ?g))

  ; From where the robot is: to the disc, close the hand, lift.
  (:stream plan-pick
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (pick-motion ?b ?p ?g ?m))

  ; Carry the disc to the pose, let go, draw back.
  (:stream plan-place
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (place-motion ?b ?p ?g ?m)))
