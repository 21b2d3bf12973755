; One cart, one forklift, two boxes: the pallet is a job for the forklift.
(define (problem warehouse-small)
  (:domain warehouse)

  (:objects
    shelf1 shelf2 - shelf
    tom - cart
    fred - forklift
    letters - parcel
    cement - pallet
    low half high - level)

  (:init
    ; the floor plan
    (path dock charger) (path charger dock) (path dock shelf1) (path shelf1 dock)
    (path shelf1 shelf2) (path shelf2 shelf1)
    ; the levels of a battery
    (below empty low) (below low half) (below half high) (below high full)
    ; the robots
    (robot-at tom dock) (battery tom full) (robot-at fred charger) (battery fred half)
    ; the boxes
    (box-at letters shelf2) (box-at cement shelf1))

  (:goal
    (and
      (box-at letters dock) (box-at cement dock))))
