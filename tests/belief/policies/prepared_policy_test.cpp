// The policy "best": the exact optimum where it can be computed, the loop otherwise.
#include "belief/policies/prepared_policy.hpp"

#include <gtest/gtest.h>

#include "belief/offline/optimal_policy.hpp"
#include "tests/belief/policies/support.hpp"

namespace praxis::belief {
namespace {

using test::load_own;
using test::Loaded;

PolicyResult run_best(const Loaded& loaded, const WorldState& first,
                      std::shared_ptr<const ConditionalPlan> prepared) {
    PolicyContext context = loaded.context();
    context.prepared = std::move(prepared);
    const auto policy = make_policy("best", context);
    Belief belief = loaded.belief();
    SimulatedWorld world(loaded.task, first);
    return run_policy(*policy, context, belief, world);
}

TEST(BestPolicy, SpendsWhatTheOptimumSpendsInTheMean) {
    for (const auto& [domain, problem] : {std::pair{"sort-weight", "two-boxes"},
                                          {"drawer-cleaning", "two-drawers"},
                                          {"same-colour", "two-cups"},
                                          {"cup-removal", "three-cups"}}) {
        const Loaded loaded = load_own(domain, problem);
        const OptimalPolicy optimum = optimal_policy(loaded.task);
        ASSERT_EQ(optimum.status, OptimalPolicy::Status::optimal) << problem;
        const auto prepared = prepare_best(loaded.task);
        ASSERT_TRUE(prepared) << problem;
        double actions = 0;
        for (const WorldState& world : optimum.worlds) {
            const PolicyResult result = run_best(loaded, world, prepared);
            EXPECT_EQ(result.run.status, RunStatus::reached) << problem;
            EXPECT_TRUE(check_run(*loaded.task, world, result.run.actions).valid) << problem;
            actions += static_cast<double>(result.steps);
        }
        EXPECT_NEAR(actions / static_cast<double>(optimum.worlds.size()), optimum.costs.mean, 1e-9)
            << problem;
    }
}

TEST(BestPolicy, WithoutAPreparedPlanItIsTheLoop) {
    const Loaded loaded = load_own("sort-weight", "two-boxes");
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const WorldState first = test::sample(loaded, seed);
        const PolicyResult best = run_best(loaded, first, nullptr);
        EXPECT_EQ(best.run.actions, test::run_named(loaded, "plan", seed).run.actions);
    }
}

/// Answers what no first state could.
class Contrary : public Environment {
  public:
    explicit Contrary(SimulatedWorld& world) : world_(world) {}
    Execution execute(std::uint32_t action, std::stop_token stop) override {
        return world_.execute(action, stop);
    }
    std::vector<Answer> observe(std::uint32_t, std::stop_token) override { return {}; }

  private:
    SimulatedWorld& world_;
};

TEST(BestPolicy, LeavesTheRestToTheLoopWhereNothingIsAnswered) {
    const Loaded loaded = load_own("sort-weight", "two-boxes");
    PolicyContext context = loaded.context(0, 30);
    context.prepared = prepare_best(loaded.task);
    const auto policy = make_policy("best", context);
    Belief belief = loaded.belief();
    SimulatedWorld world(loaded.task, test::sample(loaded, 0));
    Contrary silent(world);
    const PolicyResult result = run_policy(*policy, context, belief, silent);
    EXPECT_NE(result.run.status, RunStatus::reached);
    EXPECT_NE(result.run.status, RunStatus::illegal);
}

}  // namespace
}  // namespace praxis::belief
