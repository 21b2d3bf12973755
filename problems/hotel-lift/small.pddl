; One lift with two places, a guest, a cat and a dog that must not meet in the lift.
(define (problem hotel-lift-small)
  (:domain hotel-lift)

  (:objects
    f0 f1 f2 - floor
    lift - lift
    n0 n1 n2 - count
    ann - guest
    cat dog - pet)

  (:init
    ; the building
    (above f1 f0) (above f2 f1)
    (less n0 n1) (less n1 n2)
    ; the lifts
    (lift-at lift f0) (free lift n2)
    ; who is where and wants to go where
    (at ann f0) (wants ann f2) (at cat f0) (wants cat f2) (at dog f0) (wants dog f1)
    ; the shy ones
    (fears cat dog))

  (:goal
    (forall (?r - rider ?f - floor) (imply (wants ?r ?f) (at ?r ?f)))))
