; Two cups in view: four actions.
(define (problem cup-pick-place-two)
  (:domain cup-pick-place)
  (:objects red-cup green-cup - cup target - box table - place)
  (:init
    (on red-cup table) (on green-cup table)
    (in-view red-cup) (in-view green-cup) (hand-empty)
    (unknown (wet red-cup)) (unknown (wet green-cup)))
  (:goal (and (inside red-cup target) (inside green-cup target))))
