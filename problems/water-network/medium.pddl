; A ring of four junctions fed from one side; two pipes have burst.
(define (problem water-network-medium)
  (:domain water-network)

  (:objects
    lake - reservoir
    h1 h2 h3 h4 - house
    j1 j2 j3 j4 - junction
    main r12 r23 r34 r41 s1 s2 s3 s4 - pipe)

  (:init
    ; the pipes
    (joins main lake j1) (joins r12 j1 j2) (joins r23 j2 j3) (joins r34 j3 j4) (joins r41 j4 j1)
    (joins s1 j1 h1) (joins s2 j2 h2) (joins s3 j3 h3) (joins s4 j4 h4)
    ; the valves
    (valve main) (valve r12) (valve r34)
    ; the damage
    (burst s3) (burst r41))

  (:goal
    (and
      (forall (?h - house) (supplied ?h))
      (not (exists (?p - pipe) (burst ?p))))))
