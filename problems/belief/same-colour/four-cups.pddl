; Four cups in three drawers. Everything else is put away in the end.
(define (problem same-colour-four)
  (:domain same-colour)
  (:objects cup1 cup2 cup3 cup4 - cup drawer1 drawer2 drawer3 - drawer table - tray)
  (:init
    (at table) (hand-empty)
    (oneof (mine cup1) (mine cup2) (mine cup3) (mine cup4))
    (oneof (in cup1 drawer1) (in cup1 drawer2) (in cup1 drawer3))
    (oneof (in cup2 drawer1) (in cup2 drawer2) (in cup2 drawer3))
    (oneof (in cup3 drawer1) (in cup3 drawer2) (in cup3 drawer3))
    (oneof (in cup4 drawer1) (in cup4 drawer2) (in cup4 drawer3)))
  (:goal (and
    (served)
    (hand-empty)
    (forall (?d - drawer) (not (open ?d))))))
