; A house with two floors, a garden and a garage on the morning after the party.
(define (problem household-large)
  (:domain household)

  (:objects
    kitchen hall living study landing bedroom nursery bathroom garden garage - room
    cup mug plate bowl jug - dish
    ball bear train kite - toy)

  (:init
    ; the house
    (door kitchen hall) (door hall kitchen) (door hall living) (door living hall) (door hall study)
    (door study hall) (door hall landing) (door landing hall) (door landing bedroom)
    (door bedroom landing) (door landing nursery) (door nursery landing) (door landing bathroom)
    (door bathroom landing) (door living garden) (door garden living) (door hall garage)
    (door garage hall) (door garage garden) (door garden garage)
    (= (steps kitchen hall) 2) (= (steps hall kitchen) 2) (= (steps hall living) 3)
    (= (steps living hall) 3) (= (steps hall study) 3) (= (steps study hall) 3)
    (= (steps hall landing) 5) (= (steps landing hall) 5) (= (steps landing bedroom) 2)
    (= (steps bedroom landing) 2) (= (steps landing nursery) 2) (= (steps nursery landing) 2)
    (= (steps landing bathroom) 1) (= (steps bathroom landing) 1) (= (steps living garden) 2)
    (= (steps garden living) 2) (= (steps hall garage) 4) (= (steps garage hall) 4)
    (= (steps garage garden) 3) (= (steps garden garage) 3)
    (outdoors garden) (doormat hall) (doormat living) (doormat garage) (sink kitchen)
    (sink bathroom)
    ; where things are, where they belong, and what is dirty
    (in cup study) (in mug bedroom) (in plate garden) (in bowl nursery) (in jug living)
    (in ball garden) (in bear hall) (in train living) (in kite landing)
    (home cup kitchen) (home mug kitchen) (home plate kitchen) (home bowl kitchen)
    (home bowl living) (home jug kitchen) (home ball nursery) (home ball garage)
    (home bear nursery) (home train nursery) (home kite garage)
    (dirty cup) (dirty mug) (dirty plate) (dirty bowl) (swept study) (swept bathroom)
    ; the robot
    (robot-in garage) (= (total-cost) 0))

  (:goal
    (and
      (forall (?r - room) (or (outdoors ?r) (swept ?r)))
      (forall (?t - thing) (exists (?r - room) (and (home ?t ?r) (in ?t ?r))))
      (forall (?d - dish) (not (dirty ?d)))))

  (:metric minimize (total-cost)))
