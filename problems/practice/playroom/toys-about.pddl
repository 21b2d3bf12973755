; Both toys lie elsewhere, and so does the bin.
(define (problem playroom-toys-about)
  (:domain playroom)
  (:objects
    shelf table closet corner - place
    car duck - toy
    bin - bin
    sweeper - sweeper)
  (:init
    (closet closet) (corner corner) (pair car duck)
    (at table) (hand-empty) (on car shelf) (on duck table) (on bin shelf) (on sweeper closet)
    (closet-closed) (chair-in-corner))
  (:goal (and (in-bin car) (in-bin duck))))
