// Environments that misbehave, or in which there is nothing to do.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::quick;
using test::TestFile;
using test::Tokens;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Tokens that give NaN where they are told to, once a token is on the last place.
class Broken : public Tokens {
  public:
    enum class Part { state, features, parameters };
    explicit Broken(Part part) : Tokens(1, 3, {{0, 1}, {1, 2}, {2, 0}}), part_(part) {}
    void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                 Random& random) const override {
        Tokens::execute(state, skill, parameters, random);
        if (part_ == Part::state && state[0] == 2) state.back() = kNan;
    }
    void features(const State& state, const GroundSkill& skill, std::span<double> features) const override {
        Tokens::features(state, skill, features);
        if (part_ == Part::features && !features.empty()) features[1] = kNan;
    }
    void propose(const State& state, const GroundSkill& skill, Random& random,
                 std::span<double> parameters) const override {
        Tokens::propose(state, skill, random, parameters);
        if (part_ == Part::parameters) parameters[0] = kNan;
    }

  private:
    Part part_;
};

TEST(OddEnvironment, NumbersThatAreNotFiniteGetAClearError) {
    for (const auto& [part, word] :
         {std::pair{Broken::Part::state, "number 2 of a state"},
          {Broken::Part::features, "number 1 of the features of (mark t0 p2)"},
          {Broken::Part::parameters, "the parameters proposed for (mark t0 p2)"}}) {
        for (const MethodInfo& method : methods()) {
            for (const bool with_journal : {false, true}) {
                const TestFile file;
                PracticeOptions options = quick(method.name);
                options.test_tasks = 0;
                try {
                    run_practice(Broken(part), options, {}, with_journal ? file.path() : "");
                    ADD_FAILURE() << method.name << ": " << word;
                } catch (const std::invalid_argument& error) {
                    const std::string text = error.what();
                    EXPECT_NE(text.find("not finite"), std::string::npos) << text;
                    EXPECT_TRUE(with_journal || text.find(word) != std::string::npos) << text;
                }
                EXPECT_EQ(file.text().find("null"), std::string::npos);
            }
        }
    }
}

TEST(OddEnvironment, WhereNoSkillCanBeGroundedNothingHappens) {
    class Barren : public Tokens {
      public:
        Barren() : Tokens(1, 2, {}), description_(Tokens::description()) { description_.cycle_steps = 5; }
        const Description& description() const override { return description_; }
        PracticeTask sample_task(Random& random) const override {
            PracticeTask task = Tokens::sample_task(random);
            task.goal = {};
            return task;
        }

      private:
        Description description_;
    };
    for (const MethodInfo& method : methods()) {
        const RunResult result = run_practice(Barren(), quick(method.name));
        ASSERT_EQ(result.curve.size(), 1u) << method.name;
        EXPECT_EQ(result.curve[0].solved, 1) << method.name;
    }
}

TEST(OddEnvironment, ADeadEndEndsTheCycleAndNoMore) {
    // A token that has been marked on the last place can do nothing any more.
    const Tokens environment(1, 2, {{0, 1}});
    for (const MethodInfo& method : methods()) {
        PracticeOptions options = quick(method.name);
        options.cycle_steps = 500;
        const RunResult result = run_practice(environment, options);
        ASSERT_EQ(result.curve.size(), 4u) << method.name;
        for (std::size_t i = 1; i < 4; ++i) {
            EXPECT_GE(result.curve[i].transitions, result.curve[i - 1].transitions + 2) << method.name;
            EXPECT_LT(result.curve[i].transitions, result.curve[i - 1].transitions + 500) << method.name;
        }
        options.reset = false;
        EXPECT_EQ(run_practice(environment, options).curve.size(), 2u) << method.name;
    }
}

TEST(OddEnvironment, RefusesADescriptionWithoutAnythingToDo) {
    class Idle : public Tokens {
      public:
        Idle() : Tokens(1, 2, {{0, 1}}), description_(Tokens::description()) { description_.cycle_steps = 0; }
        const Description& description() const override { return description_; }

      private:
        Description description_;
    };
    PracticeOptions options = quick();
    options.cycle_steps = 0;
    EXPECT_THROW(run_practice(Idle(), options), std::invalid_argument);
    options.cycle_steps = 1;
    EXPECT_NO_THROW(run_practice(Idle(), options));
}

}  // namespace
}  // namespace praxis::practice
