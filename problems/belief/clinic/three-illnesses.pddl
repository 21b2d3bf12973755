; Three illnesses, two symptoms.
(define (problem clinic-three-illnesses)
  (:domain clinic)
  (:objects
    flu measles hay-fever - illness
    fever rash - symptom)
  (:init
    (oneof (ill flu) (ill measles) (ill hay-fever))
    ; a patient shows a symptom if and only if the illness causes it
    (unknown (shows fever))
    (or (not (ill flu)) (shows fever)) (or (not (ill measles)) (shows fever))
    (or (not (ill hay-fever)) (not (shows fever)))
    (unknown (shows rash))
    (or (not (ill flu)) (not (shows rash))) (or (not (ill measles)) (shows rash))
    (or (not (ill hay-fever)) (not (shows rash))))
  (:goal (treated)))
