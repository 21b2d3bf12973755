; A town with a toll bridge.
(define (problem courier-medium)
  (:domain courier)

  (:objects
    office market farm mill castle port - place
    bike - bicycle
    van - van
    bill card parcel note - letter)

  (:init
    ; roads, their lengths in kilometres and their tolls
    (road office market) (road market office) (road market farm) (road farm market)
    (road market mill) (road mill market) (road mill castle) (road castle mill) (road castle port)
    (road port castle) (road office port) (road port office)
    (= (distance office market) 1.5) (= (distance market office) 1.5)
    (= (distance market farm) 4.25) (= (distance farm market) 4.25)
    (= (distance market mill) 2.125) (= (distance mill market) 2.125)
    (= (distance mill castle) 0.75) (= (distance castle mill) 0.75) (= (distance castle port) 3)
    (= (distance port castle) 3) (= (distance office port) 9.5) (= (distance port office) 9.5)
    (= (toll office market) 0) (= (toll market office) 0) (= (toll market farm) 0)
    (= (toll farm market) 0) (= (toll market mill) 0) (= (toll mill market) 0)
    (= (toll mill castle) 2.5) (= (toll castle mill) 2.5) (= (toll castle port) 0)
    (= (toll port castle) 0) (= (toll office port) 0) (= (toll port office) 0)
    ; lanes for bicycles
    (lane office mill) (lane mill office) (lane castle farm) (lane farm castle)
    (= (distance office mill) 2.2) (= (distance mill office) 2.2) (= (distance castle farm) 1.9)
    (= (distance farm castle) 1.9)
    ; vehicles and their tariffs per kilometre
    (at bike market) (= (tariff bike) 0.2) (at van port) (= (tariff van) 0.45)
    ; letters
    (lies bill office) (lies card farm) (lies parcel port) (lies note castle)
    (= (handling) 0.05) (= (total-cost) 0))

  (:goal
    (and
      (lies bill castle) (lies card port) (lies parcel office) (lies note mill)))

  (:metric minimize (total-cost)))
