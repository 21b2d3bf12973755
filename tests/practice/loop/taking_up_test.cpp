// Runs that are cut off and taken up give what an uninterrupted run gives.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "parser/diagnostic.hpp"
#include "practice/environments/light_switch.hpp"
#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::expect_same;
using test::quick;
using test::TestFile;
using test::Tokens;

/// Another environment whose power fails when it is to execute skills once more.
class Failing : public SimulatedEnvironment {
  public:
    struct PowerCut : std::runtime_error {
        PowerCut() : runtime_error("power cut") {}
    };
    Failing(const SimulatedEnvironment& whole, int skills) : whole_(&whole), left_(skills) {}
    const Description& description() const override { return whole_->description(); }
    bool holds(const State& state, const GroundAtom& atom) const override {
        return whole_->holds(state, atom);
    }
    void propose(const State& state, const GroundSkill& skill, Random& random,
                 std::span<double> parameters) const override {
        whole_->propose(state, skill, random, parameters);
    }
    void features(const State& state, const GroundSkill& skill, std::span<double> features) const override {
        whole_->features(state, skill, features);
    }
    PracticeTask sample_task(Random& random) const override { return whole_->sample_task(random); }
    void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                 Random& random) const override {
        if (left_-- == 0) throw PowerCut();
        whole_->execute(state, skill, parameters, random);
    }

  private:
    const SimulatedEnvironment* whole_;
    mutable int left_;
};

PracticeOptions options_for(bool reset) {
    PracticeOptions options = quick();
    options.cycles = 2;
    options.cycle_steps = 12;
    options.learn_every = 5;
    options.test_tasks = 0;  // so that the environment executes practised skills only
    options.reset = reset;
    return options;
}

void expect_taken_up_anywhere(const SimulatedEnvironment& environment, bool reset) {
    const PracticeOptions options = options_for(reset);
    const TestFile undisturbed;
    const RunResult whole = run_practice(environment, options, {}, undisturbed.path());
    expect_same(whole, run_practice(environment, options));
    ASSERT_EQ(whole.curve.back().transitions, 24);
    for (int skills = 0; skills < 24; ++skills) {
        const TestFile file;
        EXPECT_THROW(run_practice(Failing(environment, skills), options, {}, file.path()), Failing::PowerCut);
        EXPECT_EQ(std::ranges::count(file.text(), '\n'), 2 + skills + (skills >= 12)) << skills;
        expect_same(run_practice(environment, options, {}, file.path()), whole);
        EXPECT_EQ(file.text(), undisturbed.text()) << skills;
    }
}

TEST(TakingUp, AfterAnySkillOnLightSwitch) {
    expect_taken_up_anywhere(LightSwitch(6), true);
    expect_taken_up_anywhere(LightSwitch(6), false);
}

TEST(TakingUp, AfterAnySkillOnTokens) {
    expect_taken_up_anywhere(Tokens(2, 3, {{0, 1}, {1, 2}, {2, 0}}), true);
    expect_taken_up_anywhere(Tokens(2, 3, {{0, 1}, {1, 2}, {2, 0}}), false);
}

TEST(TakingUp, AfterATornLineAnywhere) {
    const LightSwitch environment(6);
    PracticeOptions options = options_for(true);
    options.method = "random-skills";
    options.cycles = 1;
    const TestFile file;
    const RunResult whole = run_practice(environment, options, {}, file.path());
    const std::string text = file.text();
    for (std::size_t size = 0; size < text.size(); size += 17) {
        file.write(text.substr(0, size));
        expect_same(run_practice(environment, options, {}, file.path()), whole);
        ASSERT_EQ(file.text(), text) << size;
    }
}

TEST(TakingUp, AFinishedRunIsToldAgainAndGoesOn) {
    const LightSwitch environment(6);
    PracticeOptions options = options_for(true);
    const TestFile file;
    const RunResult whole = run_practice(environment, options, {}, file.path());
    expect_same(run_practice(Failing(environment, 0), options, {}, file.path()), whole);
    options.cycles = 3;
    expect_same(run_practice(environment, options, {}, file.path()), run_practice(environment, options));
}

TEST(TakingUp, AfterTheProcessWasKilled) {
    const Tokens environment(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    const PracticeOptions options = options_for(true);
    const RunResult whole = run_practice(environment, options);
    for (const int skills : {0, 5, 17}) {
        const TestFile file;
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            try {
                run_practice(Failing(environment, skills), options, {}, file.path());
            } catch (const Failing::PowerCut&) {
                ::kill(::getpid(), SIGKILL);
            }
            ::_exit(1);
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
        expect_same(run_practice(environment, options, {}, file.path()), whole);
    }
}

TEST(TakingUp, RefusesTheJournalOfAnotherRun) {
    const LightSwitch environment(6);
    const PracticeOptions options = options_for(true);
    const TestFile file;
    run_practice(environment, options, {}, file.path());
    const auto refuses = [&](const SimulatedEnvironment& other, const PracticeOptions& others) {
        EXPECT_THROW(run_practice(other, others, {}, file.path()), InputError)
            << settings_text(other, others);
    };
    refuses(LightSwitch(7), options);
    const auto refuses_change = [&](const auto& change) {
        PracticeOptions others = options;
        change(others);
        refuses(environment, others);
    };
    refuses_change([](PracticeOptions& o) { o.method = "fail-focus"; });
    refuses_change([](PracticeOptions& o) { o.seed = 2; });
    refuses_change([](PracticeOptions& o) { o.reset = false; });
    refuses_change([](PracticeOptions& o) { o.candidates = "all"; });
    refuses_change([](PracticeOptions& o) { o.bonus += 1e-12; });
    refuses_change([](PracticeOptions& o) { o.sharing = true; });
    refuses_change([](PracticeOptions& o) { o.competence.model = "latent"; });
    refuses_change([](PracticeOptions& o) { o.policy.epsilon = 0.25; });
    refuses_change([](PracticeOptions& o) { o.policy.classifier.neighbours = 5; });
    refuses_change([](PracticeOptions& o) { o.policy.classifier.hidden = {8}; });
}

TEST(TakingUp, WrongOptionsLeaveNoJournalBehind) {
    const LightSwitch environment(6);
    PracticeOptions options = options_for(true);
    const TestFile file;
    options.method = "es";
    EXPECT_THROW(run_practice(environment, options, {}, file.path()), std::invalid_argument);
    options.method = "ees";
    EXPECT_NO_THROW(run_practice(environment, options, {}, file.path()));
}

}  // namespace
}  // namespace praxis::practice
