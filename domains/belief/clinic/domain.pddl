; Find out what ails a patient and give the right medicine.
;
; What it shows: indirect evidence. The illness itself cannot be read. It is exactly one of several; each symptom that
; is read rules some of them out (clauses of the problem), until one is left.
(define (domain clinic)
  (:requirements :adl :contingent)

  (:types illness symptom)

  (:predicates
    (ill ?i - illness)             ; unknown at first
    (shows ?s - symptom)           ; unknown at first, tied to the illness by clauses
    (sample-taken)
    (treated))

  (:action take-sample
    :precondition (not (sample-taken))
    :effect (sample-taken))

  ; A sample is used up by one test.
  (:action test
    :parameters (?s - symptom)
    :precondition (sample-taken)
    :effect (not (sample-taken))
    :observe (shows ?s))

  ; Nobody is given a medicine for what they may not have.
  (:action give-medicine
    :parameters (?i - illness)
    :precondition (ill ?i)
    :effect (and (not (ill ?i)) (treated))))
