; Dinner: six dishes, everybody is allergic to something.
(define (problem kitchen-large)
  (:domain kitchen)

  (:objects
    onion garlic carrot fish shrimp rice nuts lettuce potato egg flour apple beef beans
    - ingredient
    knife1 knife2 - knife
    pan1 pan2 - pan
    curry chowder salad paella pie chili - dish)

  (:init
    ; the recipes
    (needs curry onion) (needs curry rice) (needs curry nuts) (needs chowder fish)
    (needs chowder potato) (needs salad lettuce) (needs salad carrot) (needs paella shrimp)
    (needs paella garlic) (needs pie apple) (needs pie flour) (needs pie egg) (needs chili beef)
    (needs chili beans)
    ; the allergies
    (avoids curry fish) (avoids curry shrimp) (avoids chowder nuts) (avoids chowder egg)
    (avoids salad fish) (avoids salad nuts) (avoids salad beef) (avoids paella beef)
    (avoids paella nuts) (avoids pie beef) (avoids pie fish) (avoids pie garlic)
    (avoids chili nuts) (avoids chili flour)
    ; the ingredients
    (tender rice) (tender nuts) (tender egg) (tender flour) (tender beans) (tender shrimp)
    (eaten-raw lettuce) (eaten-raw carrot) (eaten-raw apple)
    ; what is still dirty from yesterday
    (traces knife1 fish) (traces knife2 nuts) (traces pan1 beef) (traces pan2 garlic))

  (:goal
    (forall (?d - dish) (served ?d))))
