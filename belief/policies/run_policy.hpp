// Executes a policy: choose, act, observe, update, until the goal is known, something ends the run, or the
// policy leaves the rest to the loop.
#pragma once

#include <cstddef>
#include <functional>

#include "belief/environment.hpp"
#include "belief/policies/policy.hpp"

namespace praxis::belief {

struct PolicyResult {
    RunResult run;          ///< its actions are without those that were tried and refused
    std::size_t steps = 0;  ///< actions chosen, refused ones included
};

/// One run of a fresh policy, made of this context. An action that the world refuses ends it as illegal,
/// unless the policy tries anything. `watch` is told of every event.
PolicyResult run_policy(Policy& policy, const PolicyContext& context, Belief& belief,
                        Environment& environment, const Budget& budget = {},
                        const std::function<void(const Event&, const Belief&)>& watch = {});

}  // namespace praxis::belief
