#include <gtest/gtest.h>

#include "practice/environments/light_switch.hpp"
#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::expect_same;
using test::quick;
using test::TestFile;
using test::Tokens;

TEST(RunPractice, TheSameSeedGivesTheSameRun) {
    const Tokens environment(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    for (const MethodInfo& method : methods()) {
        const PracticeOptions options = quick(method.name, 7);
        expect_same(run_practice(environment, options), run_practice(environment, options));
    }
}

TEST(RunPractice, PlannerThreadsChangeNothing) {
    const Tokens environment(3, 4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    PracticeOptions options = quick();
    options.candidates = "all";
    const RunResult one = run_practice(environment, options);
    options.planner.threads = 2;
    expect_same(run_practice(environment, options), one);
}

TEST(RunPractice, OtherSeedsGiveOtherRuns) {
    const LightSwitch environment(6);
    const auto practised = [&](std::uint64_t seed) {
        const TestFile file;
        run_practice(environment, quick("ees", seed), {}, file.path());
        const std::string text = file.text();
        return text.substr(text.find('\n'));
    };
    EXPECT_NE(practised(1), practised(2));
    EXPECT_NE(practised(2), practised(3));
}

TEST(RunPractice, TestsLeaveNoTraceInWhatIsPractised) {
    const Tokens environment(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    for (const char* method : {"ees", "fail-focus", "task-repeat"}) {
        PracticeOptions options = quick(method);
        std::vector<PracticeChoice> choices;
        std::string practised;
        for (const int test_tasks : {0, 1, 5}) {
            for (const int test_every : {0, 1, 9}) {
                options.test_tasks = test_tasks;
                options.test_every = test_every;
                const TestFile file;
                const RunResult result = run_practice(environment, options, {}, file.path());
                const std::string text = file.text();
                const std::string records = text.substr(text.find('\n'));
                if (practised.empty()) {
                    practised = records;
                    choices = result.choices;
                }
                EXPECT_EQ(records, practised) << method << " " << test_tasks << " " << test_every;
                EXPECT_EQ(result.choices, choices) << method << " " << test_tasks << " " << test_every;
            }
        }
    }
}

TEST(RunPractice, TestsComeWhenDue) {
    const LightSwitch environment(6);
    const auto transitions = [&](int test_every) {
        PracticeOptions options = quick();
        options.cycles = 2;
        options.test_every = test_every;
        std::vector<std::pair<int, std::int64_t>> result;
        for (const CurvePoint& point : run_practice(environment, options).curve)
            result.emplace_back(point.cycle, point.transitions);
        return result;
    };
    using Times = std::vector<std::pair<int, std::int64_t>>;
    EXPECT_EQ(transitions(0), (Times{{0, 0}, {1, 20}, {2, 40}}));
    EXPECT_EQ(transitions(1), (Times{{0, 0}, {1, 7}, {1, 14}, {1, 20}, {2, 27}, {2, 34}, {2, 40}}));
    EXPECT_EQ(transitions(10), (Times{{0, 0}, {1, 14}, {1, 20}, {2, 34}, {2, 40}}));
}

TEST(RunPractice, AStoppedRunEndsWithItsLastWholeCycle) {
    const LightSwitch environment(6);
    PracticeOptions options = quick();
    const RunResult whole = run_practice(environment, options);
    std::stop_source source;
    PracticeHooks hooks;
    hooks.stop = source.get_token();
    int tests = 0;
    hooks.on_test = [&](const RunResult& result) {
        EXPECT_EQ(result.curve.size(), static_cast<std::size_t>(++tests));
        if (tests == 2) source.request_stop();
    };
    const RunResult stopped = run_practice(environment, options, hooks);
    EXPECT_EQ(stopped.curve, std::vector(whole.curve.begin(), whole.curve.begin() + 2));
}

TEST(RunPractice, EachCycleLeavesItsFirstChoice) {
    const LightSwitch environment(6);
    const RunResult result = run_practice(environment, quick("fail-focus"));
    ASSERT_EQ(result.choices.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const PracticeChoice& choice = result.choices[i];
        EXPECT_EQ(choice.cycle, static_cast<int>(i) + 1);
        EXPECT_GE(choice.transitions, static_cast<std::int64_t>(20 * i));
        EXPECT_LT(choice.transitions, static_cast<std::int64_t>(20 * (i + 1)));
        ASSERT_FALSE(choice.candidates.empty());
        EXPECT_EQ(choice.chosen, choice.candidates.front().skill);
        for (std::size_t c = 1; c < choice.candidates.size(); ++c)
            EXPECT_GE(choice.candidates[c - 1].score, choice.candidates[c].score);
    }
}

}  // namespace
}  // namespace praxis::practice
