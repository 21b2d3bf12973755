; A town: a grid of twenty junctions, two reservoirs, eight houses and six burst pipes.
(define (problem water-network-large)
  (:domain water-network)

  (:objects
    lake tower - reservoir
    h1 h2 h3 h4 h5 h6 h7 h8 - house
    j11 j12 j13 j14 j15 j21 j22 j23 j24 j25 j31 j32 j33 j34 j35 j41 j42 j43 j44 j45 - junction
    main1 main2 e11 n11 e12 n12 e13 n13 e14 n14 n15 e21 n21 e22 n22 e23 n23 e24 n24 n25 e31 n31 e32
    n32 e33 n33 e34 n34 n35 e41 e42 e43 e44 s1 s2 s3 s4 s5 s6 s7 s8 - pipe)

  (:init
    ; the pipes
    (joins main1 lake j11) (joins main2 tower j45) (joins e11 j11 j12) (joins n11 j11 j21)
    (joins e12 j12 j13) (joins n12 j12 j22) (joins e13 j13 j14) (joins n13 j13 j23)
    (joins e14 j14 j15) (joins n14 j14 j24) (joins n15 j15 j25) (joins e21 j21 j22)
    (joins n21 j21 j31) (joins e22 j22 j23) (joins n22 j22 j32) (joins e23 j23 j24)
    (joins n23 j23 j33) (joins e24 j24 j25) (joins n24 j24 j34) (joins n25 j25 j35)
    (joins e31 j31 j32) (joins n31 j31 j41) (joins e32 j32 j33) (joins n32 j32 j42)
    (joins e33 j33 j34) (joins n33 j33 j43) (joins e34 j34 j35) (joins n34 j34 j44)
    (joins n35 j35 j45) (joins e41 j41 j42) (joins e42 j42 j43) (joins e43 j43 j44)
    (joins e44 j44 j45) (joins s1 j12 h1) (joins s2 j14 h2) (joins s3 j22 h3) (joins s4 j24 h4)
    (joins s5 j31 h5) (joins s6 j35 h6) (joins s7 j42 h7) (joins s8 j44 h8)
    ; the valves
    (valve main1) (valve main2) (valve e12) (valve e22) (valve e32) (valve e42) (valve n21)
    (valve n23) (valve n25) (valve s3)
    ; the damage
    (burst s1) (burst s6) (burst e22) (burst n14) (burst e44) (burst n31))

  (:goal
    (and
      (forall (?h - house) (supplied ?h))
      (not (exists (?p - pipe) (burst ?p))))))
