; Two lifts, six floors, five guests and three pets.
(define (problem hotel-lift-medium)
  (:domain hotel-lift)

  (:objects
    f0 f1 f2 f3 f4 f5 - floor
    left right - lift
    n0 n1 n2 n3 - count
    ann bob cleo dan eve - guest
    cat dog mouse - pet)

  (:init
    ; the building
    (above f1 f0) (above f2 f1) (above f3 f2) (above f4 f3) (above f5 f4)
    (less n0 n1) (less n1 n2) (less n2 n3)
    ; the lifts
    (lift-at left f0) (free left n3) (lift-at right f5) (free right n2)
    ; who is where and wants to go where
    (at ann f0) (wants ann f5) (at bob f5) (wants bob f0) (at cleo f2) (wants cleo f4) (at dan f3)
    (wants dan f1) (at eve f0) (wants eve f3) (at cat f0) (wants cat f5) (at dog f0) (wants dog f3)
    (at mouse f2) (wants mouse f4)
    ; the shy ones
    (fears cat dog) (fears mouse cat))

  (:goal
    (forall (?r - rider ?f - floor) (imply (wants ?r ?f) (at ?r ?f)))))
