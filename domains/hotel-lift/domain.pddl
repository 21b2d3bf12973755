; The lifts of a hotel take guests and their pets to their floors.
;
; What it shows: a universally quantified goal, counting with objects, a quantified precondition over fluents.
;
; A lift moves by one floor and has a limited number of free places. A shy animal does not travel with a stranger's
; pet, so before a pet boards no other pet that it fears, or that fears it, may be in the lift.
(define (domain hotel-lift)
  (:requirements :adl)

  (:types rider lift floor count - object
          guest pet - rider)

  (:predicates
    (above ?high ?low - floor)           ; directly
    (less ?fewer ?more - count)          ; by one
    (fears ?a ?b - pet)
    (wants ?r - rider ?f - floor)

    (lift-at ?l - lift ?f - floor)
    (free ?l - lift ?n - count)
    (at ?r - rider ?f - floor)
    (inside ?r - rider ?l - lift))

  (:action up
    :parameters (?l - lift ?from ?to - floor)
    :precondition (and (lift-at ?l ?from) (above ?to ?from))
    :effect (and (not (lift-at ?l ?from)) (lift-at ?l ?to)))

  (:action down
    :parameters (?l - lift ?from ?to - floor)
    :precondition (and (lift-at ?l ?from) (above ?from ?to))
    :effect (and (not (lift-at ?l ?from)) (lift-at ?l ?to)))

  (:action board-guest
    :parameters (?g - guest ?l - lift ?f - floor ?more ?fewer - count)
    :precondition (and (lift-at ?l ?f) (at ?g ?f) (free ?l ?more) (less ?fewer ?more))
    :effect (and
      (not (at ?g ?f)) (inside ?g ?l)
      (not (free ?l ?more)) (free ?l ?fewer)))

  (:action board-pet
    :parameters (?p - pet ?l - lift ?f - floor ?more ?fewer - count)
    :precondition (and
      (lift-at ?l ?f) (at ?p ?f) (free ?l ?more) (less ?fewer ?more)
      (forall (?q - pet)
        (imply (inside ?q ?l) (and (not (fears ?p ?q)) (not (fears ?q ?p))))))
    :effect (and
      (not (at ?p ?f)) (inside ?p ?l)
      (not (free ?l ?more)) (free ?l ?fewer)))

  (:action leave
    :parameters (?r - rider ?l - lift ?f - floor ?fewer ?more - count)
    :precondition (and (lift-at ?l ?f) (inside ?r ?l) (free ?l ?fewer) (less ?fewer ?more))
    :effect (and
      (not (inside ?r ?l)) (at ?r ?f)
      (not (free ?l ?fewer)) (free ?l ?more))))
