; A small kitchen: chop, fry, serve, and wash the tools in between.
;
; What it shows: negative and disjunctive preconditions, implications, nested quantifiers.
;
; A tool that touched an ingredient keeps traces of it until it is washed, and a guest's dish must not be made with a
; tool that carries something the dish must avoid.
(define (domain kitchen)
  (:requirements :adl)

  (:types ingredient tool dish - object
          knife pan - tool)

  (:predicates
    (needs ?d - dish ?i - ingredient)
    (avoids ?d - dish ?i - ingredient)   ; somebody is allergic
    (tender ?i - ingredient)             ; need not be chopped before frying
    (eaten-raw ?i - ingredient)          ; need not be fried

    (chopped ?i - ingredient)
    (fried ?i - ingredient)
    (used-up ?i - ingredient)
    (traces ?t - tool ?i - ingredient)
    (tainted ?i ?by - ingredient)
    (served ?d - dish))

  (:action chop
    :parameters (?i - ingredient ?k - knife)
    :precondition (and (not (chopped ?i)) (not (fried ?i)) (not (used-up ?i)))
    :effect (and
      (chopped ?i)
      (traces ?k ?i)
      (forall (?other - ingredient) (when (traces ?k ?other) (tainted ?i ?other)))))

  (:action fry
    :parameters (?i - ingredient ?p - pan)
    :precondition (and
      (not (used-up ?i))
      (not (fried ?i))
      (or (chopped ?i) (tender ?i)))
    :effect (and
      (fried ?i)
      (traces ?p ?i)
      (forall (?other - ingredient) (when (traces ?p ?other) (tainted ?i ?other)))))

  (:action wash
    :parameters (?t - tool)
    :precondition (exists (?i - ingredient) (traces ?t ?i))
    :effect (forall (?i - ingredient) (not (traces ?t ?i))))

  ; Everything the dish needs is there and ready, and nothing in it was tainted by what the dish avoids.
  (:action serve
    :parameters (?d - dish)
    :precondition (and
      (not (served ?d))
      (forall (?i - ingredient)
        (imply (needs ?d ?i)
          (and
            (not (used-up ?i))
            (or (fried ?i) (eaten-raw ?i))
            (forall (?bad - ingredient) (not (and (avoids ?d ?bad) (tainted ?i ?bad))))))))
    :effect (and
      (served ?d)
      (forall (?i - ingredient) (when (needs ?d ?i) (used-up ?i))))))
