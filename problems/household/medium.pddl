; A flat with a terrace after breakfast.
(define (problem household-medium)
  (:domain household)

  (:objects
    kitchen hall living bedroom terrace - room
    cup plate bowl - dish
    ball bear - toy)

  (:init
    ; the house
    (door kitchen hall) (door hall kitchen) (door hall living) (door living hall)
    (door hall bedroom) (door bedroom hall) (door living terrace) (door terrace living)
    (= (steps kitchen hall) 2) (= (steps hall kitchen) 2) (= (steps hall living) 3)
    (= (steps living hall) 3) (= (steps hall bedroom) 2) (= (steps bedroom hall) 2)
    (= (steps living terrace) 2) (= (steps terrace living) 2)
    (outdoors terrace) (doormat living) (doormat hall) (sink kitchen)
    ; where things are, where they belong, and what is dirty
    (in cup living) (in plate terrace) (in bowl kitchen) (in ball terrace) (in bear kitchen)
    (home cup kitchen) (home plate kitchen) (home bowl kitchen) (home ball bedroom)
    (home ball hall) (home bear bedroom)
    (dirty cup) (dirty plate) (dirty bowl) (swept bedroom)
    ; the robot
    (robot-in hall) (= (total-cost) 0))

  (:goal
    (and
      (forall (?r - room) (or (outdoors ?r) (swept ?r)))
      (forall (?t - thing) (exists (?r - room) (and (home ?t ?r) (in ?t ?r))))
      (forall (?d - dish) (not (dirty ?d)))))

  (:metric minimize (total-cost)))
