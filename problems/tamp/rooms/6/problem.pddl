; 6 things in 4 rooms; half of them have to go to another room.
(define (problem rooms-6-1)
  (:domain pick-place)
  (:objects on-table1 on-table2 on-table3 on-table4 - region
            thing1 thing2 thing3 thing4 thing5 thing6 - body
            p-thing1 p-thing2 p-thing3 p-thing4 p-thing5 p-thing6 - pose)
  (:init (hand-empty)
         (graspable thing1) (pose-of thing1 p-thing1) (at thing1 p-thing1)
         (placeable thing1 on-table2)
         (graspable thing2) (pose-of thing2 p-thing2) (at thing2 p-thing2)
         (graspable thing3) (pose-of thing3 p-thing3) (at thing3 p-thing3)
         (placeable thing3 on-table1)
         (graspable thing4) (pose-of thing4 p-thing4) (at thing4 p-thing4)
         (graspable thing5) (pose-of thing5 p-thing5) (at thing5 p-thing5)
         (placeable thing5 on-table4)
         (graspable thing6) (pose-of thing6 p-thing6) (at thing6 p-thing6))
  (:goal (and (in thing1 on-table2)
              (in thing3 on-table1)
              (in thing5 on-table4))))
