; Four aisles of five shelves, four robots, eight boxes.
(define (problem warehouse-large)
  (:domain warehouse)

  (:objects
    a1 a2 a3 a4 a5 b1 b2 b3 b4 b5 c1 c2 c3 c4 c5 d1 d2 d3 d4 d5 - shelf
    tom tim - cart
    fred frida - forklift
    books shoes lamps tools tea - parcel
    cement bricks timber - pallet
    l1 l2 l3 l4 l5 l6 l7 l8 l9 l10 l11 l12 l13 l14 l15 - level)

  (:init
    ; the floor plan
    (path dock charger) (path charger dock) (path dock a1) (path a1 dock) (path dock b1)
    (path b1 dock) (path charger c1) (path c1 charger) (path charger d1) (path d1 charger)
    (path a1 a2) (path a2 a1) (path a2 a3) (path a3 a2) (path a3 a4) (path a4 a3) (path a4 a5)
    (path a5 a4) (path b1 b2) (path b2 b1) (path b2 b3) (path b3 b2) (path b3 b4) (path b4 b3)
    (path b4 b5) (path b5 b4) (path c1 c2) (path c2 c1) (path c2 c3) (path c3 c2) (path c3 c4)
    (path c4 c3) (path c4 c5) (path c5 c4) (path d1 d2) (path d2 d1) (path d2 d3) (path d3 d2)
    (path d3 d4) (path d4 d3) (path d4 d5) (path d5 d4) (path a5 b5) (path b5 a5) (path b5 c5)
    (path c5 b5) (path c5 d5) (path d5 c5)
    ; the levels of a battery
    (below empty l1) (below l1 l2) (below l2 l3) (below l3 l4) (below l4 l5) (below l5 l6)
    (below l6 l7) (below l7 l8) (below l8 l9) (below l9 l10) (below l10 l11) (below l11 l12)
    (below l12 l13) (below l13 l14) (below l14 l15) (below l15 full)
    ; the robots
    (robot-at tom dock) (battery tom full) (robot-at tim c1) (battery tim l6) (robot-at fred b1)
    (battery fred l5) (robot-at frida charger) (battery frida full)
    ; the boxes
    (box-at books b3) (box-at shoes d4) (box-at lamps d3) (box-at tools a5) (box-at tea c2)
    (box-at cement d5) (box-at bricks d1) (box-at timber d4))

  (:goal
    (and
      (box-at books dock) (box-at shoes dock) (box-at lamps dock) (box-at tools dock)
      (box-at tea dock) (box-at cement dock) (box-at bricks dock) (box-at timber dock))))
