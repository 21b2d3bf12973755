// MAPLE-Q has nothing but rewards to learn from: it learns where random skills meet them, and not elsewhere.
#include <gtest/gtest.h>

#include "practice/environments/ball_ring.hpp"
#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::quick;
using test::RecordingWorld;
using test::Tokens;

TEST(MapleQ, LearnsTheWayAndTheParameterWithinThreeHundredSkills) {
    const Tokens corridor(1, 4, {{0, 1}, {1, 2}, {2, 3}, {1, 0}, {2, 1}, {3, 2}});
    for (const std::uint64_t seed : {1u, 2u}) {
        PracticeOptions options = quick("maple-q", seed);
        options.cycles = 20;
        options.cycle_steps = 15;
        options.learn_every = 0;
        options.test_tasks = 50;
        const RunResult run = run_practice(corridor, options);
        ASSERT_EQ(run.curve.back().transitions, 300);
        EXPECT_LT(run.curve.front().solved, 0.3) << "by chance";
        EXPECT_GT(run.curve.back().solved, 0.75) << "seed " << seed;
    }
}

/// The goal of ball-ring takes the right eight skills; it is never met, and nothing can be learned.
TEST(MapleQ, MeetsNoRewardOnBallRing) {
    const BallRing environment(BallRing::Features::relative);
    for (const std::uint64_t seed : {0u, 1u}) {
        PracticeOptions options = quick("maple-q", seed);
        options.cycle_steps = 250;
        options.learn_every = 0;
        RecordingWorld world(environment, seed);
        PracticeLoop loop(environment, world, options);
        for (int cycle = 0; cycle < 10; ++cycle) loop.run_cycle();
        const SkillTask& skills = loop.learner().skills();
        Random random(seed);
        const std::vector<Fact> goal = skills.goal(environment.sample_task(random).goal);
        ASSERT_EQ(world.steps.size(), 2500u);
        for (const JournalStep& step : world.steps) EXPECT_FALSE(skills.holds(goal, step.state));
    }
}

}  // namespace
}  // namespace praxis::practice
