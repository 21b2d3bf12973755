; Breakfast: fried eggs for a guest who must not eat nuts; the only pan fried nuts yesterday.
(define (problem kitchen-small)
  (:domain kitchen)

  (:objects
    egg nuts apple - ingredient
    knife - knife
    pan - pan
    eggs muesli - dish)

  (:init
    ; the recipes
    (needs eggs egg) (needs muesli nuts) (needs muesli apple)
    ; the allergies
    (avoids eggs nuts)
    ; the ingredients
    (tender egg) (tender nuts) (eaten-raw apple)
    ; what is still dirty from yesterday
    (traces pan nuts))

  (:goal
    (forall (?d - dish) (served ?d))))
