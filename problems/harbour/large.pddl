; Two ships, five quays, six containers, three cars.
(define (problem harbour-large)
  (:domain harbour)

  (:objects
    north south east island cape - quay
    big old small tall - crane
    anna bertha - ship
    red blue green white black grey - container
    beetle mini taxi - car
    dora emil - driver)

  (:init
    ; the harbour
    (street north south) (street south north) (street south east) (street east south)
    (reaches big north) (reaches old east) (reaches small island) (reaches tall cape)
    ; the ships
    (moored anna north) (moored bertha cape) (berth-free east) (berth-free island)
    ; the cargo
    (stands red north) (stands blue island) (stands green cape) (stands white east)
    (stands black cape) (stands grey island) (stands beetle south) (stands mini island)
    (stands taxi east)
    ; the drivers
    (waits dora north) (waits emil south))

  (:goal
    (and
      (stands red island) (stands blue cape) (stands green north) (stands white cape)
      (stands black island) (stands grey north) (stands beetle cape) (stands mini south)
      (stands taxi north) (waits dora north) (waits emil east))))
