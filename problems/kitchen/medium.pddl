; Lunch for three, one knife, two pans.
(define (problem kitchen-medium)
  (:domain kitchen)

  (:objects
    onion carrot fish rice nuts lettuce potato - ingredient
    knife - knife
    pan1 pan2 - pan
    curry chowder salad - dish)

  (:init
    ; the recipes
    (needs curry onion) (needs curry rice) (needs curry nuts) (needs chowder fish)
    (needs chowder potato) (needs salad lettuce) (needs salad carrot)
    ; the allergies
    (avoids curry fish) (avoids chowder nuts) (avoids salad fish) (avoids salad nuts)
    ; the ingredients
    (tender rice) (tender nuts) (eaten-raw lettuce) (eaten-raw carrot)
    ; what is still dirty from yesterday
    (traces knife fish) (traces pan1 nuts) (traces pan2 fish))

  (:goal
    (forall (?d - dish) (served ?d))))
