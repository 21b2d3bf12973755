// What holds of every environment: states agree with PDDL whatever the skills do, and practice never ends.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "parser/parser.hpp"
#include "practice/environments/environments.hpp"
#include "search/session.hpp"
#include "tests/practice/environments/abstract_task.hpp"

namespace praxis::practice::test {
namespace {

constexpr int kWalk = 10000;

class EveryEnvironment : public testing::TestWithParam<std::string> {
  protected:
    const std::unique_ptr<SimulatedEnvironment> environment_ = make_environment(GetParam());
    const AbstractTask task_{*environment_};

    std::vector<double> proposal(const State& state, std::size_t skill, Random& random) const {
        std::vector<double> parameters(task_.parameter_count(skill));
        environment_->propose(state, task_.skills()[skill], random, parameters);
        return parameters;
    }
    std::vector<std::size_t> applicable(const AbstractTask::Values& values) const {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < task_.skills().size(); ++i)
            if (task_.applicable(values, i)) result.push_back(i);
        return result;
    }
    /// Applicable skills at random, with proposed parameters.
    template <class Visit>
    void walk(int steps, Random& random, Visit visit) const {
        State state = environment_->sample_task(random).initial;
        for (int step = 0; step < steps; ++step) {
            const auto before = task_.values(state);
            ASSERT_TRUE(before);
            const std::vector<std::size_t> choice = applicable(*before);
            ASSERT_FALSE(choice.empty());
            const std::size_t skill = choice[random.below(choice.size())];
            const State old = state;
            environment_->execute(state, task_.skills()[skill], proposal(state, skill, random), random);
            const auto after = task_.values(state);
            ASSERT_TRUE(after) << task_.name(skill);
            visit(old, *before, skill, state, *after);
        }
    }
};

TEST_P(EveryEnvironment, SuccessIsWhatPddlPromisesAndNothingElse) {
    Random random(1);
    std::map<std::string, int> promised;
    walk(kWalk, random,
         [&](const State&, const auto& before, std::size_t skill, const State& state, const auto& after) {
             const AbstractTask::Values expected = task_.successor(before, skill);
             bool added = true;
             for (std::size_t v = 0; v < before.size(); ++v)
                 if (expected[v] != before[v] && after[v] != expected[v]) added = false;
             if (added) {
                 EXPECT_EQ(after, expected) << task_.name(skill);
                 if (expected != before) ++promised[task_.schema_name(skill)];
             }
             for (const double number : state) EXPECT_TRUE(std::isfinite(number)) << task_.name(skill);
         });
    EXPECT_GE(promised.size(), environment_->description().schemas.size() / 2);
}

TEST_P(EveryEnvironment, OutOfPlaceASkillDoesNothing) {
    Random random(2);
    walk(200, random, [&](const State&, const auto&, std::size_t, const State& state, const auto& after) {
        for (std::size_t i = 0; i < task_.skills().size(); ++i) {
            if (task_.applicable(after, i)) continue;
            State copy = state;
            environment_->execute(copy, task_.skills()[i], proposal(state, i, random), random);
            EXPECT_EQ(copy, state) << task_.name(i);
        }
    });
}

TEST_P(EveryEnvironment, PracticeCanAlwaysGoOn) {
    Random random(3);
    int step = 0;
    walk(kWalk, random, [&](const State&, const auto&, std::size_t, const State& state, const auto&) {
        if (++step % (kWalk / 5) == 0) task_.expect_practice_goes_on(state);
    });
}

TEST_P(EveryEnvironment, TheSameSeedIsTheSameWalk) {
    const auto trace = [&] {
        Random random(4);
        std::vector<State> states;
        walk(100, random, [&](const State&, const auto&, std::size_t, const State& state, const auto&) {
            states.push_back(state);
        });
        return states;
    };
    EXPECT_EQ(trace(), trace());
}

TEST_P(EveryEnvironment, TasksAreUnsolvedAndPlansFitTheHorizon) {
    Random random(5);
    for (int i = 0; i < 30; ++i) {
        const PracticeTask task = environment_->sample_task(random);
        EXPECT_FALSE(task_.reached(task.initial, task.goal));
        const auto distance = task_.distance(task);
        ASSERT_TRUE(distance);
        EXPECT_LE(*distance, environment_->description().horizon);
    }
}

TEST_P(EveryEnvironment, WritesFiniteFeaturesAndNamesTheRelevantOnes) {
    Random random(6);
    const Description& description = environment_->description();
    for (const SkillSchema& schema : description.schemas)
        for (const std::size_t feature : schema.relevant_features) EXPECT_LT(feature, schema.features.size());
    walk(200, random, [&](const State& old, const auto&, std::size_t skill, const State&, const auto&) {
        const auto schema = static_cast<std::size_t>(task_.skills()[skill].schema);
        std::vector<double> features(description.schemas[schema].features.size(),
                                     std::numeric_limits<double>::quiet_NaN());
        environment_->features(old, task_.skills()[skill], features);
        for (const double feature : features) EXPECT_TRUE(std::isfinite(feature)) << task_.name(skill);
    });
}

TEST_P(EveryEnvironment, RefusesWhatDoesNotFit) {
    Random random(7);
    State state = environment_->sample_task(random).initial;
    const State before = state;
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < task_.skills().size(); ++i) {
        std::vector<double> parameters(task_.parameter_count(i) + 1);
        EXPECT_THROW(environment_->execute(state, task_.skills()[i], parameters, random),
                     std::invalid_argument);
        parameters.pop_back();
        for (double& parameter : parameters) {
            for (const double number : bad) {
                parameter = number;
                EXPECT_THROW(environment_->execute(state, task_.skills()[i], parameters, random),
                             std::invalid_argument);
            }
            parameter = 0;
        }
        GroundSkill more = task_.skills()[i];
        more.objects.push_back(0);
        EXPECT_THROW(environment_->execute(state, more, parameters, random), std::invalid_argument);
        GroundSkill unknown = task_.skills()[i];
        unknown.schema = 1000;
        EXPECT_THROW(environment_->execute(state, unknown, parameters, random), std::invalid_argument);
    }
    EXPECT_EQ(state, before);
    EXPECT_THROW(environment_->holds(state, {-1, {}}), std::invalid_argument);
    EXPECT_THROW(environment_->holds(state, {0, std::vector<std::int32_t>(9)}), std::invalid_argument);
    EXPECT_THROW(environment_->holds({}, {0, {}}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Environments, EveryEnvironment,
                         testing::Values("light-switch(cells=8)", "ball-ring", "ball-ring(features=relative)",
                                         "kitchen", "playroom"),
                         [](const auto& environment) {
                             std::string name = environment.param;
                             std::replace_if(
                                 name.begin(), name.end(),
                                 [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; },
                                 '_');
                             return name;
                         });

TEST(Environments, AreMadeByName) {
    for (const std::string& name : environment_names())
        EXPECT_EQ(make_environment(name)->description().name, name);
    EXPECT_EQ(make_environment("light-switch(12)")->description().horizon, 14);
    for (const char* wrong :
         {"", "light", "ball-rings", "light-switch(cells=2)", "light-switch(cells=1e9)",
          "light-switch(cells=x)", "light-switch(rows=5)", "kitchen(5)", "ball-ring(features=all)",
          "ball-ring(raw,raw)", "ball-ring(", "ball-ring([raw])"})
        EXPECT_THROW(make_environment(wrong), std::invalid_argument) << wrong;
}

TEST(Environments, EveryPublishedProblemHasAPlan) {
    const std::filesystem::path root = PRAXIS_SOURCE_DIR;
    std::size_t count = 0;
    for (const std::string& name : environment_names()) {
        for (const auto& file : std::filesystem::directory_iterator(root / "problems/practice" / name)) {
            const LoadResult loaded = load_with_warnings(
                (root / "domains/practice" / name / "domain.pddl").string(), file.path().string());
            EXPECT_TRUE(loaded.warnings.empty()) << file.path();
            EXPECT_TRUE(Session(loaded.task).plan(alias("agile")).plan) << file.path();
            ++count;
        }
    }
    EXPECT_GE(count, environment_names().size());
}

}  // namespace
}  // namespace praxis::practice::test
