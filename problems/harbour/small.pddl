; One container has to get onto the ship and one car off it.
(define (problem harbour-small)
  (:domain harbour)

  (:objects
    north south - quay
    crane - crane
    anna - ship
    box - container
    beetle - car
    dora - driver)

  (:init
    ; the harbour
    (street north south) (street south north)
    (reaches crane north)
    ; the ships
    (moored anna north)
    ; the cargo
    (stands box north) (stands beetle anna)
    ; the drivers
    (waits dora north))

  (:goal
    (and
      (stands box anna) (stands beetle south))))
