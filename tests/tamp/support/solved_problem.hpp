// A small problem and what `solve` finds for it, for tests that break one thing of it.
#pragma once

#include <string>

#include "tests/tamp/support/generated_problem.hpp"

namespace praxis::tamp {

struct SolvedProblem {
    SceneProblem problem;
    Solution solution;

    SolvedProblem(const std::string& family, int size)
        : problem(scene_problem(generate_problem(family, size, 1))), solution(solve(problem)) {}

    const RefinedPlan& plan() const { return *solution.refinement.plan; }
};

/// Two sticks are sorted: pick, place, pick, place.
inline const SolvedProblem& sorted_sticks() {
    static const SolvedProblem solved("clutter", 2);
    return solved;
}

/// Two discs of Hanoi, whose poses the scene names.
inline const SolvedProblem& moved_discs() {
    static const SolvedProblem solved("hanoi", 2);
    return solved;
}

}  // namespace praxis::tamp
