; Six by six, made dark again by at most eight presses.
(define (problem lights-large)
  (:domain lights)

  (:objects
    l11 l12 l13 l14 l15 l16 - lamp
    l21 l22 l23 l24 l25 l26 - lamp
    l31 l32 l33 l34 l35 l36 - lamp
    l41 l42 l43 l44 l45 l46 - lamp
    l51 l52 l53 l54 l55 l56 - lamp
    l61 l62 l63 l64 l65 l66 - lamp)

  (:init
    ; who is near whom
    (near l11 l11) (near l11 l21) (near l11 l12)
    (near l12 l12) (near l12 l22) (near l12 l11) (near l12 l13)
    (near l13 l13) (near l13 l23) (near l13 l12) (near l13 l14)
    (near l14 l14) (near l14 l24) (near l14 l13) (near l14 l15)
    (near l15 l15) (near l15 l25) (near l15 l14) (near l15 l16)
    (near l16 l16) (near l16 l26) (near l16 l15)
    (near l21 l21) (near l21 l11) (near l21 l31) (near l21 l22)
    (near l22 l22) (near l22 l12) (near l22 l32) (near l22 l21) (near l22 l23)
    (near l23 l23) (near l23 l13) (near l23 l33) (near l23 l22) (near l23 l24)
    (near l24 l24) (near l24 l14) (near l24 l34) (near l24 l23) (near l24 l25)
    (near l25 l25) (near l25 l15) (near l25 l35) (near l25 l24) (near l25 l26)
    (near l26 l26) (near l26 l16) (near l26 l36) (near l26 l25)
    (near l31 l31) (near l31 l21) (near l31 l41) (near l31 l32)
    (near l32 l32) (near l32 l22) (near l32 l42) (near l32 l31) (near l32 l33)
    (near l33 l33) (near l33 l23) (near l33 l43) (near l33 l32) (near l33 l34)
    (near l34 l34) (near l34 l24) (near l34 l44) (near l34 l33) (near l34 l35)
    (near l35 l35) (near l35 l25) (near l35 l45) (near l35 l34) (near l35 l36)
    (near l36 l36) (near l36 l26) (near l36 l46) (near l36 l35)
    (near l41 l41) (near l41 l31) (near l41 l51) (near l41 l42)
    (near l42 l42) (near l42 l32) (near l42 l52) (near l42 l41) (near l42 l43)
    (near l43 l43) (near l43 l33) (near l43 l53) (near l43 l42) (near l43 l44)
    (near l44 l44) (near l44 l34) (near l44 l54) (near l44 l43) (near l44 l45)
    (near l45 l45) (near l45 l35) (near l45 l55) (near l45 l44) (near l45 l46)
    (near l46 l46) (near l46 l36) (near l46 l56) (near l46 l45)
    (near l51 l51) (near l51 l41) (near l51 l61) (near l51 l52)
    (near l52 l52) (near l52 l42) (near l52 l62) (near l52 l51) (near l52 l53)
    (near l53 l53) (near l53 l43) (near l53 l63) (near l53 l52) (near l53 l54)
    (near l54 l54) (near l54 l44) (near l54 l64) (near l54 l53) (near l54 l55)
    (near l55 l55) (near l55 l45) (near l55 l65) (near l55 l54) (near l55 l56)
    (near l56 l56) (near l56 l46) (near l56 l66) (near l56 l55)
    (near l61 l61) (near l61 l51) (near l61 l62)
    (near l62 l62) (near l62 l52) (near l62 l61) (near l62 l63)
    (near l63 l63) (near l63 l53) (near l63 l62) (near l63 l64)
    (near l64 l64) (near l64 l54) (near l64 l63) (near l64 l65)
    (near l65 l65) (near l65 l55) (near l65 l64) (near l65 l66)
    (near l66 l66) (near l66 l56) (near l66 l65)
    ; the lamps that are on
    (lit l11) (lit l12) (lit l13) (lit l14) (lit l15) (lit l16) (lit l21) (lit l22) (lit l24)
    (lit l25) (lit l32) (lit l34) (lit l36) (lit l41) (lit l43) (lit l46) (lit l51) (lit l54)
    (lit l55) (lit l62) (lit l63) (lit l65))

  (:goal
    (forall (?l - lamp) (not (lit ?l)))))
