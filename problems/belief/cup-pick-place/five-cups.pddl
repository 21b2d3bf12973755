; Five cups on two tables, one of them in view.
(define (problem cup-pick-place-five)
  (:domain cup-pick-place)
  (:objects cup1 cup2 cup3 cup4 cup5 - cup target - box table shelf - place)
  (:init
    (on cup1 table) (on cup2 table) (on cup3 shelf) (on cup4 shelf) (on cup5 shelf)
    (in-view cup1) (hand-empty)
    (unknown (wet cup1)) (unknown (wet cup2)) (unknown (wet cup3)) (unknown (wet cup4))
    (unknown (wet cup5)))
  (:goal (forall (?c - cup) (inside ?c target))))
