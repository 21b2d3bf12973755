; One bicycle, one van, three places: who should bring the letter?
(define (problem courier-small)
  (:domain courier)

  (:objects
    office market farm - place
    bike - bicycle
    van - van
    bill - letter)

  (:init
    ; roads, their lengths in kilometres and their tolls
    (road office market) (road market office) (road market farm) (road farm market)
    (= (distance office market) 1.5) (= (distance market office) 1.5)
    (= (distance market farm) 4.25) (= (distance farm market) 4.25)
    (= (toll office market) 0) (= (toll market office) 0) (= (toll market farm) 1.2)
    (= (toll farm market) 1.2)
    ; lanes for bicycles
    (lane office farm) (lane farm office)
    (= (distance office farm) 3.8) (= (distance farm office) 3.8)
    ; vehicles and their tariffs per kilometre
    (at bike office) (= (tariff bike) 0.25) (at van market) (= (tariff van) 0.4)
    ; letters
    (lies bill office)
    (= (handling) 0.1) (= (total-cost) 0))

  (:goal
    (and
      (lies bill farm)))

  (:metric minimize (total-cost)))
