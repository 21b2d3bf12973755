(define (stream line)
  (:stream sample-pose
    :inputs (?b - block ?r - region)
    :domain (stackable ?b ?r)
    :outputs (?p - pose)
    :certified (and (pose ?b ?p) (contained ?b ?p ?r)))

  (:stream sample-grasp
    :inputs (?b - block)
    :outputs (?g - grasp)
    :certified (grasp ?b ?g))

  (:stream inverse-kinematics
    :inputs (?b - block ?p - pose ?g - grasp)
    :domain (and (pose ?b ?p) (grasp ?b ?g))
    :outputs (?q - configuration)
    :certified (and (kinematics ?b ?p ?g ?q) (configuration ?q)))

  (:stream plan-motion
    :inputs (?from ?to - configuration)
    :domain (and (configuration ?from) (configuration ?to))
    :outputs (?t - path)
    :certified (motion ?from ?t ?to))

  (:stream test-apart
    :inputs (?b1 - block ?p1 - pose ?b2 - block ?p2 - pose)
    :domain (and (pose ?b1 ?p1) (pose ?b2 ?p2))
    :certified (apart ?b1 ?p1 ?b2 ?p2))

  (:function (distance ?from ?to - configuration)
    (and (configuration ?from) (configuration ?to))))
