; Four by four; at most five presses.
(define (problem lights-medium)
  (:domain lights)

  (:objects
    l11 l12 l13 l14 - lamp
    l21 l22 l23 l24 - lamp
    l31 l32 l33 l34 - lamp
    l41 l42 l43 l44 - lamp)

  (:init
    ; who is near whom
    (near l11 l11) (near l11 l21) (near l11 l12)
    (near l12 l12) (near l12 l22) (near l12 l11) (near l12 l13)
    (near l13 l13) (near l13 l23) (near l13 l12) (near l13 l14)
    (near l14 l14) (near l14 l24) (near l14 l13)
    (near l21 l21) (near l21 l11) (near l21 l31) (near l21 l22)
    (near l22 l22) (near l22 l12) (near l22 l32) (near l22 l21) (near l22 l23)
    (near l23 l23) (near l23 l13) (near l23 l33) (near l23 l22) (near l23 l24)
    (near l24 l24) (near l24 l14) (near l24 l34) (near l24 l23)
    (near l31 l31) (near l31 l21) (near l31 l41) (near l31 l32)
    (near l32 l32) (near l32 l22) (near l32 l42) (near l32 l31) (near l32 l33)
    (near l33 l33) (near l33 l23) (near l33 l43) (near l33 l32) (near l33 l34)
    (near l34 l34) (near l34 l24) (near l34 l44) (near l34 l33)
    (near l41 l41) (near l41 l31) (near l41 l42)
    (near l42 l42) (near l42 l32) (near l42 l41) (near l42 l43)
    (near l43 l43) (near l43 l33) (near l43 l42) (near l43 l44)
    (near l44 l44) (near l44 l34) (near l44 l43)
    ; the lamps that are on
    (lit l11) (lit l13) (lit l14) (lit l24) (lit l31) (lit l41) (lit l43) (lit l44))

  (:goal
    (forall (?l - lamp) (not (lit ?l)))))
