; Three by three; three presses are enough.
(define (problem lights-small)
  (:domain lights)

  (:objects
    l11 l12 l13 - lamp
    l21 l22 l23 - lamp
    l31 l32 l33 - lamp)

  (:init
    ; who is near whom
    (near l11 l11) (near l11 l21) (near l11 l12)
    (near l12 l12) (near l12 l22) (near l12 l11) (near l12 l13)
    (near l13 l13) (near l13 l23) (near l13 l12)
    (near l21 l21) (near l21 l11) (near l21 l31) (near l21 l22)
    (near l22 l22) (near l22 l12) (near l22 l32) (near l22 l21) (near l22 l23)
    (near l23 l23) (near l23 l13) (near l23 l33) (near l23 l22)
    (near l31 l31) (near l31 l21) (near l31 l32)
    (near l32 l32) (near l32 l22) (near l32 l31) (near l32 l33)
    (near l33 l33) (near l33 l23) (near l33 l32)
    ; the lamps that are on
    (lit l11) (lit l23) (lit l31) (lit l33))

  (:goal
    (forall (?l - lamp) (not (lit ?l)))))
