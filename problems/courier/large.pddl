; Sixteen places, four vehicles, twelve letters.
(define (problem courier-large)
  (:domain courier)

  (:objects
    p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 p13 p14 p15 p16 - place
    bike1 bike2 - bicycle
    van1 van2 - van
    l1 l2 l3 l4 l5 l6 l7 l8 l9 l10 l11 l12 - letter)

  (:init
    ; roads, their lengths in kilometres and their tolls
    (road p1 p2) (road p2 p1) (road p2 p3) (road p3 p2) (road p1 p4) (road p4 p1) (road p4 p5)
    (road p5 p4) (road p5 p6) (road p6 p5) (road p3 p7) (road p7 p3) (road p7 p8) (road p8 p7)
    (road p6 p9) (road p9 p6) (road p6 p10) (road p10 p6) (road p8 p11) (road p11 p8) (road p8 p12)
    (road p12 p8) (road p12 p13) (road p13 p12) (road p11 p14) (road p14 p11) (road p11 p15)
    (road p15 p11) (road p14 p16) (road p16 p14) (road p3 p12) (road p12 p3) (road p11 p13)
    (road p13 p11) (road p10 p1) (road p1 p10) (road p4 p7) (road p7 p4) (road p10 p7)
    (road p7 p10) (road p1 p14) (road p14 p1)
    (= (distance p1 p2) 9.25) (= (distance p2 p1) 9.25) (= (distance p2 p3) 8.5)
    (= (distance p3 p2) 8.5) (= (distance p1 p4) 3.25) (= (distance p4 p1) 3.25)
    (= (distance p4 p5) 3.25) (= (distance p5 p4) 3.25) (= (distance p5 p6) 5.25)
    (= (distance p6 p5) 5.25) (= (distance p3 p7) 9.0) (= (distance p7 p3) 9.0)
    (= (distance p7 p8) 7.5) (= (distance p8 p7) 7.5) (= (distance p6 p9) 0.5)
    (= (distance p9 p6) 0.5) (= (distance p6 p10) 1.25) (= (distance p10 p6) 1.25)
    (= (distance p8 p11) 4.25) (= (distance p11 p8) 4.25) (= (distance p8 p12) 7.75)
    (= (distance p12 p8) 7.75) (= (distance p12 p13) 9.75) (= (distance p13 p12) 9.75)
    (= (distance p11 p14) 5.0) (= (distance p14 p11) 5.0) (= (distance p11 p15) 1.75)
    (= (distance p15 p11) 1.75) (= (distance p14 p16) 7.0) (= (distance p16 p14) 7.0)
    (= (distance p3 p12) 3.0) (= (distance p12 p3) 3.0) (= (distance p11 p13) 2.75)
    (= (distance p13 p11) 2.75) (= (distance p10 p1) 1.5) (= (distance p1 p10) 1.5)
    (= (distance p4 p7) 1.75) (= (distance p7 p4) 1.75) (= (distance p10 p7) 1.5)
    (= (distance p7 p10) 1.5) (= (distance p1 p14) 6.375) (= (distance p14 p1) 6.375)
    (= (toll p1 p2) 0.5) (= (toll p2 p1) 0.5) (= (toll p2 p3) 1.75) (= (toll p3 p2) 1.75)
    (= (toll p1 p4) 1.75) (= (toll p4 p1) 1.75) (= (toll p4 p5) 0) (= (toll p5 p4) 0)
    (= (toll p5 p6) 0) (= (toll p6 p5) 0) (= (toll p3 p7) 0) (= (toll p7 p3) 0)
    (= (toll p7 p8) 1.75) (= (toll p8 p7) 1.75) (= (toll p6 p9) 1.75) (= (toll p9 p6) 1.75)
    (= (toll p6 p10) 0) (= (toll p10 p6) 0) (= (toll p8 p11) 1.75) (= (toll p11 p8) 1.75)
    (= (toll p8 p12) 0) (= (toll p12 p8) 0) (= (toll p12 p13) 0) (= (toll p13 p12) 0)
    (= (toll p11 p14) 0.5) (= (toll p14 p11) 0.5) (= (toll p11 p15) 0.5) (= (toll p15 p11) 0.5)
    (= (toll p14 p16) 1.75) (= (toll p16 p14) 1.75) (= (toll p3 p12) 0) (= (toll p12 p3) 0)
    (= (toll p11 p13) 0) (= (toll p13 p11) 0) (= (toll p10 p1) 0) (= (toll p1 p10) 0)
    (= (toll p4 p7) 0) (= (toll p7 p4) 0) (= (toll p10 p7) 0) (= (toll p7 p10) 0)
    (= (toll p1 p14) 0) (= (toll p14 p1) 0)
    ; lanes for bicycles
    (lane p7 p15) (lane p15 p7) (lane p16 p7) (lane p7 p16) (lane p13 p7) (lane p7 p13)
    (= (distance p7 p15) 1.1) (= (distance p15 p7) 1.1) (= (distance p16 p7) 5.3)
    (= (distance p7 p16) 5.3) (= (distance p13 p7) 1.2) (= (distance p7 p13) 1.2)
    ; vehicles and their tariffs per kilometre
    (at bike1 p1) (= (tariff bike1) 0.2) (at bike2 p9) (= (tariff bike2) 0.15) (at van1 p4)
    (= (tariff van1) 0.45) (at van2 p16) (= (tariff van2) 0.375)
    ; letters
    (lies l1 p3) (lies l2 p11) (lies l3 p14) (lies l4 p4) (lies l5 p8) (lies l6 p4) (lies l7 p2)
    (lies l8 p16) (lies l9 p7) (lies l10 p7) (lies l11 p5) (lies l12 p13)
    (= (handling) 0.05) (= (total-cost) 0))

  (:goal
    (and
      (lies l1 p5) (lies l2 p1) (lies l3 p13) (lies l4 p3) (lies l5 p12) (lies l6 p1) (lies l7 p8)
      (lies l8 p3) (lies l9 p8) (lies l10 p12) (lies l11 p7) (lies l12 p2)))

  (:metric minimize (total-cost)))
