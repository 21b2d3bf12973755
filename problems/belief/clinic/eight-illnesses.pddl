; Eight illnesses, all combinations of three symptoms.
(define (problem clinic-eight-illnesses)
  (:domain clinic)
  (:objects
    illness0 illness1 illness2 illness3 illness4 illness5 illness6 illness7 - illness
    cough fever rash - symptom)
  (:init
    (oneof (ill illness0) (ill illness1) (ill illness2) (ill illness3) (ill illness4) (ill illness5)
      (ill illness6) (ill illness7))
    ; a patient shows a symptom if and only if the illness causes it
    (unknown (shows cough))
    (or (not (ill illness0)) (not (shows cough))) (or (not (ill illness1)) (not (shows cough)))
    (or (not (ill illness2)) (not (shows cough))) (or (not (ill illness3)) (not (shows cough)))
    (or (not (ill illness4)) (shows cough)) (or (not (ill illness5)) (shows cough))
    (or (not (ill illness6)) (shows cough)) (or (not (ill illness7)) (shows cough))
    (unknown (shows fever))
    (or (not (ill illness0)) (not (shows fever))) (or (not (ill illness1)) (shows fever))
    (or (not (ill illness2)) (not (shows fever))) (or (not (ill illness3)) (shows fever))
    (or (not (ill illness4)) (not (shows fever))) (or (not (ill illness5)) (shows fever))
    (or (not (ill illness6)) (not (shows fever))) (or (not (ill illness7)) (shows fever))
    (unknown (shows rash))
    (or (not (ill illness0)) (not (shows rash))) (or (not (ill illness1)) (not (shows rash)))
    (or (not (ill illness2)) (shows rash)) (or (not (ill illness3)) (shows rash))
    (or (not (ill illness4)) (not (shows rash))) (or (not (ill illness5)) (not (shows rash)))
    (or (not (ill illness6)) (shows rash)) (or (not (ill illness7)) (shows rash)))
  (:goal (treated)))
