; Two rooms and a garden: one dirty cup, one ball outside.
(define (problem household-small)
  (:domain household)

  (:objects
    kitchen hall garden - room
    cup - dish
    ball - toy)

  (:init
    ; the house
    (door kitchen hall) (door hall kitchen) (door hall garden) (door garden hall)
    (= (steps kitchen hall) 2) (= (steps hall kitchen) 2) (= (steps hall garden) 3)
    (= (steps garden hall) 3)
    (outdoors garden) (doormat hall) (sink kitchen)
    ; where things are, where they belong, and what is dirty
    (in cup hall) (in ball garden)
    (home cup kitchen) (home ball hall)
    (dirty cup) (swept kitchen)
    ; the robot
    (robot-in kitchen) (= (total-cost) 0))

  (:goal
    (and
      (forall (?r - room) (or (outdoors ?r) (swept ?r)))
      (forall (?t - thing) (exists (?r - room) (and (home ?t ?r) (in ?t ?r))))
      (forall (?d - dish) (not (dirty ?d)))))

  (:metric minimize (total-cost)))
