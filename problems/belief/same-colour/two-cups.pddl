; Two cups in two drawers. Everything else is put away in the end.
(define (problem same-colour-two)
  (:domain same-colour)
  (:objects cup1 cup2 - cup drawer1 drawer2 - drawer table - tray)
  (:init
    (at table) (hand-empty)
    (oneof (mine cup1) (mine cup2))
    (oneof (in cup1 drawer1) (in cup1 drawer2))
    (oneof (in cup2 drawer1) (in cup2 drawer2)))
  (:goal (and
    (served)
    (hand-empty)
    (forall (?d - drawer) (not (open ?d))))))
