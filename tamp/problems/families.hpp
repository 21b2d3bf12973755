// The generators of the families; `generate.cpp` lists them.
#pragma once

#include <string>

#include "search/engines/random.hpp"
#include "tamp/problems/generate.hpp"

namespace praxis::tamp {

/// What a generator is asked for; the size is within the family's range.
struct ProblemRequest {
    std::string name = {};  ///< of the problem in PDDL
    int size = 1;
    Random random{0};
    bool feasible = true;
};

/// Evenly spread in [lower, upper).
inline double uniform(Random& random, double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(random.next() >> 11) * 0x1p-53);
}

GeneratedProblem blocked_shelf(ProblemRequest request);
GeneratedProblem non_monotonic(ProblemRequest request);
GeneratedProblem point_cloud_shelf(ProblemRequest request);
GeneratedProblem clutter(ProblemRequest request);
GeneratedProblem hanoi(ProblemRequest request);
GeneratedProblem blocks(ProblemRequest request);
GeneratedProblem packing(ProblemRequest request);
GeneratedProblem kitchen(ProblemRequest request);
GeneratedProblem rooms(ProblemRequest request);
GeneratedProblem rooms_octomap(ProblemRequest request);
GeneratedProblem namo(ProblemRequest request);

}  // namespace praxis::tamp
