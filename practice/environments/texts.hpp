// The PDDL texts of the environments, taken from domains/practice and problems/practice when Praxis is built.
#pragma once

namespace praxis::practice::texts {

extern const char* const kLightSwitchDomain;
extern const char* const kBallRingDomain;
extern const char* const kBallRingProblem;
extern const char* const kKitchenDomain;
extern const char* const kKitchenProblem;
extern const char* const kPlayroomDomain;
extern const char* const kPlayroomProblem;

}  // namespace praxis::practice::texts
