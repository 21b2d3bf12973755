; Six shelves in two aisles; batteries last for six drives.
(define (problem warehouse-medium)
  (:domain warehouse)

  (:objects
    a1 a2 a3 b1 b2 b3 - shelf
    tom - cart
    fred - forklift
    books shoes lamps - parcel
    cement bricks - pallet
    l1 l2 l3 l4 l5 - level)

  (:init
    ; the floor plan
    (path dock charger) (path charger dock) (path dock a1) (path a1 dock) (path a1 a2) (path a2 a1)
    (path a2 a3) (path a3 a2) (path charger b1) (path b1 charger) (path b1 b2) (path b2 b1)
    (path b2 b3) (path b3 b2) (path a3 b3) (path b3 a3)
    ; the levels of a battery
    (below empty l1) (below l1 l2) (below l2 l3) (below l3 l4) (below l4 l5) (below l5 full)
    ; the robots
    (robot-at tom dock) (battery tom l2) (robot-at fred b1) (battery fred l3)
    ; the boxes
    (box-at books a3) (box-at shoes b2) (box-at lamps a2) (box-at cement b3) (box-at bricks a1))

  (:goal
    (and
      (box-at books dock) (box-at shoes dock) (box-at lamps dock) (box-at cement dock)
      (box-at bricks dock))))
