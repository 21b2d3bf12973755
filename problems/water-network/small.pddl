; One main with a valve, two houses, one burst pipe behind the junction.
(define (problem water-network-small)
  (:domain water-network)

  (:objects
    lake - reservoir
    home mill - house
    j - junction
    main p1 p2 - pipe)

  (:init
    ; the pipes
    (joins main lake j) (joins p1 j home) (joins p2 j mill)
    ; the valves
    (valve main)
    ; the damage
    (burst p1))

  (:goal
    (and
      (forall (?h - house) (supplied ?h))
      (not (exists (?p - pipe) (burst ?p))))))
