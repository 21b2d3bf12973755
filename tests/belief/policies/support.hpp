// Tasks and runs for the tests of policies.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "belief/check_run.hpp"
#include "belief/policies/run_policy.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::belief::test {

/// A task, grounded and compiled.
struct Loaded {
    std::shared_ptr<const BeliefTask> task;
    std::shared_ptr<const KnowledgePlanner> planner;

    PolicyContext context(std::uint64_t seed = 0, std::size_t most_steps = 1000) const {
        PolicyContext result;
        result.options.most_steps = most_steps;
        result.planner = planner;
        result.seed = seed;
        return result;
    }
    Belief belief() const { return Belief(planner->shared_compilation()); }
};

inline Loaded compile(const ContingentLoadResult& source) {
    Loaded result;
    result.task = ground_belief(source.task).task;
    result.planner =
        std::make_shared<const KnowledgePlanner>(std::make_shared<const Compilation>(result.task));
    return result;
}

/// One of our own problems: "drawer-cleaning", "one-drawer".
inline Loaded load_own(const std::string& domain, const std::string& problem) {
    const std::string root = PRAXIS_SOURCE_DIR;
    return compile(load_contingent(root + "/domains/belief/" + domain + "/domain.pddl",
                                   root + "/problems/belief/" + domain + "/" + problem + ".pddl"));
}

inline Loaded load_text(const std::string& domain, const std::string& problem) {
    return compile(parse_contingent({"domain.pddl", domain}, {"problem.pddl", problem}));
}

inline WorldState sample(const Loaded& loaded, std::uint64_t seed) {
    Random random(seed);
    const auto world = sample_world(*loaded.task, random);
    EXPECT_TRUE(world);
    return world.value();
}

/// A run of the policy of that name in a sampled world.
inline PolicyResult run_named(const Loaded& loaded, const std::string& name, std::uint64_t seed,
                              std::size_t most_steps = 1000, double noise = 0, bool sticky = false) {
    PolicyContext context = loaded.context(seed, most_steps);
    context.options.ignore_contradictions = sticky;
    const auto policy = make_policy(name, context);
    Belief belief = loaded.belief();
    SimulatedWorld world(loaded.task, sample(loaded, seed), noise, seed);
    return run_policy(*policy, context, belief, world);
}

}  // namespace praxis::belief::test
