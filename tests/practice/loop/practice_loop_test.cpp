#include "practice/loop/practice_loop.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "practice/environments/light_switch.hpp"
#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::quick;
using test::RecordingWorld;
using test::Tokens;

TEST(PracticeLoop, ACycleTakesExactlyItsSteps) {
    const LightSwitch environment(6);
    for (const int steps : {1, 2, 13, 40}) {
        PracticeOptions options = quick();
        options.cycle_steps = steps;
        RecordingWorld world(environment, options.seed);
        PracticeLoop loop(environment, world, options);
        for (int cycle = 1; cycle <= 3; ++cycle) {
            EXPECT_TRUE(loop.run_cycle());
            EXPECT_EQ(world.steps.size(), static_cast<std::size_t>(cycle * steps));
            EXPECT_EQ(loop.learner().transitions(), cycle * steps);
        }
    }
}

TEST(PracticeLoop, TheEnvironmentSaysHowLongACycleIsUnlessTold) {
    const Tokens environment(1, 3, {{0, 1}, {1, 2}, {2, 0}});
    PracticeOptions options = quick();
    options.cycle_steps = 0;
    RecordingWorld world(environment, options.seed);
    PracticeLoop loop(environment, world, options);
    loop.run_cycle();
    EXPECT_EQ(loop.learner().transitions(), environment.description().cycle_steps);
}

/// Tokens whose marking never succeeds, so that a task takes its whole horizon.
class Unmarkable : public Tokens {
  public:
    using Tokens::Tokens;
    void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                 Random& random) const override {
        if (skill.schema == 0) Tokens::execute(state, skill, parameters, random);
    }
};

TEST(PracticeLoop, TaskTimeEndsWithTheHorizon) {
    const Unmarkable environment(1, 2, {{0, 1}});
    const auto horizon = static_cast<std::size_t>(environment.description().horizon);
    PracticeOptions options = quick("task-repeat");
    options.cycle_steps = static_cast<int>(horizon) + 6;
    RecordingWorld world(environment, options.seed);
    PracticeLoop loop(environment, world, options);
    loop.run_cycle();
    ASSERT_EQ(world.steps.size(), horizon + 6);
    // In task time choices are greedy: the policy's, of all proposals. In free time the world is the same.
    EXPECT_EQ(world.steps[0].skill.schema, 0);
    for (std::size_t i = 1; i < horizon; ++i) EXPECT_EQ(world.steps[i].skill.schema, 1);
    EXPECT_EQ(loop.learner().competences().outcomes(loop.learner().skills().find("(mark t0 p1)")).failures,
              static_cast<std::int64_t>(horizon) + 5);
}

TEST(PracticeLoop, LearnsAfterEachIntervalAndAtTheEndOfACycle) {
    const LightSwitch environment(6);
    const auto learned_at = [&](int learn_every) {
        PracticeOptions options = quick();
        options.learn_every = learn_every;
        RecordingWorld world(environment, options.seed);
        PracticeLoop loop(environment, world, options);
        std::vector<std::size_t> times;
        for (int cycle = 0; cycle < 2; ++cycle)
            loop.run_cycle({}, [&] { times.push_back(world.steps.size()); });
        return times;
    };
    EXPECT_EQ(learned_at(0), (std::vector<std::size_t>{20, 40}));
    EXPECT_EQ(learned_at(7), (std::vector<std::size_t>{7, 14, 20, 27, 34, 40}));
    EXPECT_EQ(learned_at(20), (std::vector<std::size_t>{20, 40}));
    EXPECT_EQ(learned_at(1000), (std::vector<std::size_t>{20, 40}));
}

TEST(PracticeLoop, StopsInTheMiddleOfACycle) {
    const LightSwitch environment(6);
    for (const std::size_t after : {0u, 3u, 11u}) {
        std::stop_source source;
        class Stopping : public RecordingWorld {
          public:
            using RecordingWorld::RecordingWorld;
            void execute(const GroundSkill& skill, std::span<const double> parameters) override {
                RecordingWorld::execute(skill, parameters);
                if (steps.size() == after) source->request_stop();
            }
            std::size_t after = 0;
            std::stop_source* source = nullptr;
        } world(environment, 1);
        world.after = after;
        world.source = &source;
        if (after == 0) source.request_stop();
        PracticeLoop loop(environment, world, quick());
        EXPECT_FALSE(loop.run_cycle(source.get_token()));
        EXPECT_EQ(world.steps.size(), after);
    }
}

TEST(PracticeLoop, WithoutResetsTheWorldStaysAsItWasLeft) {
    const LightSwitch environment(6);
    for (const bool reset : {true, false}) {
        PracticeOptions options = quick("random-skills");
        options.cycles = 4;
        RecordingWorld world(environment, options.seed, reset);
        PracticeLoop loop(environment, world, options);
        for (int cycle = 0; cycle < options.cycles; ++cycle) loop.run_cycle();
        ASSERT_EQ(world.task_states.size(), 4u);
        for (std::size_t task = 0; task < 4; ++task) {
            if (reset) {
                EXPECT_EQ(world.task_states[task][0], 0);
            } else if (task > 0) {
                EXPECT_EQ(world.task_states[task], world.steps[task * 20 - 1].state);
            }
        }
        EXPECT_EQ(world.task_states[0] == world.task_states[1], false);
    }
}

/// Tokens whose tasks hold from the beginning.
class Done : public Tokens {
  public:
    using Tokens::Tokens;
    PracticeTask sample_task(Random& random) const override {
        PracticeTask task = Tokens::sample_task(random);
        for (const GroundAtom& atom : task.goal)
            task.initial[1 + static_cast<std::size_t>(atom.objects[0])] = 1;
        return task;
    }
};

TEST(PracticeLoop, AGoalThatHoldsLeavesAllTimeFree) {
    const Done environment(1, 3, {{0, 1}, {1, 2}, {2, 0}});
    for (const MethodInfo& method : methods()) {
        PracticeOptions options = quick(method.name);
        const RunResult result = run_practice(environment, options);
        for (const CurvePoint& point : result.curve) EXPECT_EQ(point.solved, 1) << method.name;
        EXPECT_EQ(result.curve.back().transitions, 60) << method.name;
    }
}

TEST(PracticeLoop, SolvesLearnsNothing) {
    const Tokens environment(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    RecordingWorld world(environment, 1);
    PracticeLoop loop(environment, world, quick());
    loop.run_cycle();
    const std::int64_t tries = loop.learner().competences().tries();
    Random random(5);
    for (int i = 0; i < 10; ++i) loop.solves(environment, environment.sample_task(random), random);
    EXPECT_EQ(loop.learner().competences().tries(), tries);
    EXPECT_EQ(loop.learner().transitions(), tries);
    EXPECT_EQ(world.steps.size(), static_cast<std::size_t>(tries));
}

TEST(PracticeLoop, RefusesOptionsOutOfRange) {
    const LightSwitch environment(6);
    const auto refuses = [&](const std::function<void(PracticeOptions&)>& change) {
        PracticeOptions options = quick();
        change(options);
        SimulatedWorld world(environment, 1);
        EXPECT_THROW(PracticeLoop(environment, world, options), std::invalid_argument)
            << settings_text(environment, options);
    };
    refuses([](PracticeOptions& o) { o.method = "eees"; });
    refuses([](PracticeOptions& o) { o.cycles = -1; });
    refuses([](PracticeOptions& o) { o.cycle_steps = -1; });
    refuses([](PracticeOptions& o) { o.learn_every = -1; });
    refuses([](PracticeOptions& o) { o.test_tasks = -1; });
    refuses([](PracticeOptions& o) { o.test_every = -1; });
    refuses([](PracticeOptions& o) { o.situations = 0; });
    refuses([](PracticeOptions& o) { o.replans = -1; });
    refuses([](PracticeOptions& o) { o.bonus = -0.1; });
    refuses([](PracticeOptions& o) { o.bonus = std::numeric_limits<double>::quiet_NaN(); });
    refuses([](PracticeOptions& o) { o.bonus = std::numeric_limits<double>::infinity(); });
    refuses([](PracticeOptions& o) { o.candidates = "some"; });
    refuses([](PracticeOptions& o) { o.competence.model = "gamma"; });
    refuses([](PracticeOptions& o) { o.competence.prior = {0, 1}; });
    refuses([](PracticeOptions& o) { o.policy.epsilon = 1.5; });
    refuses([](PracticeOptions& o) { o.policy.candidates = 0; });
    refuses([](PracticeOptions& o) { o.policy.classifier.kind = "oracle"; });
    refuses([](PracticeOptions& o) { o.planner.search = "best()"; });
    refuses([](PracticeOptions& o) { o.planner.threads = 0; });
}

}  // namespace
}  // namespace praxis::practice
