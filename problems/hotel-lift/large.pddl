; Three lifts, twelve floors, fourteen guests and five pets.
(define (problem hotel-lift-large)
  (:domain hotel-lift)

  (:objects
    f0 f1 f2 f3 f4 f5 f6 f7 f8 f9 f10 f11 - floor
    left middle right - lift
    n0 n1 n2 n3 n4 - count
    ann bob cleo dan eve finn gina hugo iris jack kim leo mia nils - guest
    cat dog mouse parrot hamster - pet)

  (:init
    ; the building
    (above f1 f0) (above f2 f1) (above f3 f2) (above f4 f3) (above f5 f4) (above f6 f5)
    (above f7 f6) (above f8 f7) (above f9 f8) (above f10 f9) (above f11 f10)
    (less n0 n1) (less n1 n2) (less n2 n3) (less n3 n4)
    ; the lifts
    (lift-at left f0) (free left n4) (lift-at middle f6) (free middle n3) (lift-at right f11)
    (free right n4)
    ; who is where and wants to go where
    (at ann f9) (wants ann f4) (at bob f11) (wants bob f5) (at cleo f11) (wants cleo f10)
    (at dan f8) (wants dan f0) (at eve f7) (wants eve f3) (at finn f10) (wants finn f0)
    (at gina f2) (wants gina f1) (at hugo f5) (wants hugo f7) (at iris f3) (wants iris f6)
    (at jack f8) (wants jack f1) (at kim f9) (wants kim f3) (at leo f0) (wants leo f3) (at mia f6)
    (wants mia f4) (at nils f2) (wants nils f6) (at cat f2) (wants cat f1) (at dog f2)
    (wants dog f9) (at mouse f9) (wants mouse f7) (at parrot f2) (wants parrot f11) (at hamster f0)
    (wants hamster f11)
    ; the shy ones
    (fears cat dog) (fears mouse cat) (fears hamster cat) (fears parrot cat) (fears hamster dog))

  (:goal
    (forall (?r - rider ?f - floor) (imply (wants ?r ?f) (at ?r ?f)))))
