(define (stream configurations)
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

  ; The robot before the body, from where the hand goes straight to the grasp.
  (:stream inverse-kinematics
    :inputs (?b - body ?p - pose ?g - grasp)
    :domain (and (pose-of ?b ?p) (grasp-of ?b ?g))
    :outputs (?q - configuration)
    :certified (and (before ?b ?p ?g ?q) (configuration-of ?q)))

  ; From one configuration to another, with an empty hand, and with a body in it.
  (:stream plan-free-motion
    :inputs (?q1 ?q2 - configuration)
    :domain (and (configuration-of ?q1) (configuration-of ?q2))
    :fluents (at)
    :outputs (?m - motion)
    :certified (free-motion ?q1 ?q2 ?m))
  (:stream plan-holding-motion
    :inputs (?q1 ?q2 - configuration ?b - body ?g - grasp)
    :domain (and (configuration-of ?q1) (configuration-of ?q2) (grasp-of ?b ?g))
    :fluents (at)
    :outputs (?m - motion)
    :certified (holding-motion ?q1 ?q2 ?b ?g ?m))

  ; To the body, close the hand, and back; to the place, open the hand, and back.
  (:stream plan-grasp
    :inputs (?b - body ?p - pose ?g - grasp ?q - configuration)
    :domain (before ?b ?p ?g ?q)
    :fluents (at)
    :outputs (?m - motion)
    :certified (grasp-motion ?b ?p ?g ?q ?m))
  (:stream plan-release
    :inputs (?b - body ?p - pose ?g - grasp ?q - configuration)
    :domain (before ?b ?p ?g ?q)
    :fluents (at)
    :outputs (?m - motion)
    :certified (release-motion ?b ?p ?g ?q ?m))

  ; How long a motion is.
  (:function (motion-length ?m - motion)))
