// What a run of practice can be told.
#pragma once

#include <cstdint>
#include <string>

#include "practice/competence/competence_model.hpp"
#include "practice/planning/cost_planner.hpp"
#include "practice/policies/parameter_policy.hpp"

namespace praxis::practice {

struct PracticeOptions {
    std::string method = "ees";  ///< see `method_names`
    std::uint64_t seed = 0;
    int cycles = 10;
    int cycle_steps = 0;  ///< skills a cycle; 0: what the environment says
    /// Skills after which the parameter policies are learned anew, also within a cycle; 0: at the end of each
    /// cycle only.
    int learn_every = 25;
    int test_tasks = 100;
    /// Skills after which the robot is tested, the next time that it has learned. Besides, it is tested after
    /// each cycle; 0: only then.
    int test_every = 0;
    /// Each cycle begins with a task and its initial state; otherwise the world stays as it was left.
    bool reset = true;
    /// Which skills may be practised: those "tried" at least once, or "all".
    std::string candidates = "tried";
    /// Attempts of a skill after which the scores are made anew (sooner where policies are learned or the
    /// skill is out of reach).
    int score_every = 5;
    /// Weight of the upper-confidence bonus sqrt(ln(all tries) / tries) in scores.
    double bonus = 0.1;
    /// Tasks over which plans are costed: the first `situations` seen, and the last `replans` states in which
    /// a plan had to be made anew because a skill had failed.
    int situations = 10, replans = 5;
    bool sharing = false;  ///< an untried skill starts from the success of others of its schema
    CompetenceOptions competence;
    PolicyOptions policy;
    CostPlannerOptions planner;
};

}  // namespace praxis::practice
