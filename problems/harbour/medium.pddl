; The ship calls at two quays; the containers change places.
(define (problem harbour-medium)
  (:domain harbour)

  (:objects
    north south island - quay
    big small - crane
    anna - ship
    red blue green - container
    beetle - car
    dora - driver)

  (:init
    ; the harbour
    (street north south) (street south north)
    (reaches big north) (reaches small island)
    ; the ships
    (moored anna north) (berth-free island) (berth-free south)
    ; the cargo
    (stands red north) (stands blue island) (stands green south) (stands beetle south)
    ; the drivers
    (waits dora north))

  (:goal
    (and
      (stands red island) (stands blue north) (stands green south) (stands beetle island)
      (waits dora north))))
