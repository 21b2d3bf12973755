#include "practice/experiment/experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "parser/diagnostic.hpp"
#include "practice/experiment/time_left.hpp"

namespace praxis::practice {
namespace {

namespace fs = std::filesystem;

ExperimentOptions small_options() {
    ExperimentOptions options;
    options.environments = {"light-switch(cells=4)", "ball-ring"};
    options.methods = {"ees", "random-skills"};
    options.first_seed = 7;
    options.seeds = 2;
    options.practice.cycles = 2;
    options.practice.cycle_steps = 12;
    options.practice.test_tasks = 3;
    return options;
}

class ExperimentTest : public ::testing::Test {
  protected:
    ExperimentTest() {
        std::string name = (fs::temp_directory_path() / "praxis-experiment-XXXXXX").string();
        folder_ = ::mkdtemp(name.data()) != nullptr ? name : "";
    }
    ~ExperimentTest() override { fs::remove_all(folder_); }

    ExperimentOptions kept() const {
        ExperimentOptions options = small_options();
        options.results = (folder_ / "results").string();
        return options;
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_ / "results"), fs::directory_iterator()));
    }

    fs::path folder_;
};

std::vector<RunResult> run_all(const ExperimentOptions& options) {
    Experiment experiment(options);
    EXPECT_EQ(experiment.run(), Stop::none);
    return experiment.results();
}

/// What chance and time alone decide is left out.
std::vector<RunResult> without_times(std::vector<RunResult> runs) {
    for (RunResult& run : runs) run.processor_seconds = run.evaluation_seconds = 0;
    return runs;
}

std::string refusal(const ExperimentOptions& options) {
    try {
        run_all(options);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Experiment, RunsAreOrderedAndComplete) {
    const std::vector<RunResult> runs = run_all(small_options());
    ASSERT_EQ(runs.size(), 8u);
    std::size_t i = 0;
    for (const char* environment : {"light-switch(cells=4)", "ball-ring"})
        for (const char* method : {"ees", "random-skills"})
            for (const std::uint64_t seed : {7u, 8u}) {
                EXPECT_EQ(runs[i].environment, environment);
                EXPECT_EQ(runs[i].method, method);
                EXPECT_EQ(runs[i].seed, seed);
                EXPECT_EQ(runs[i].curve.size(), 3u);
                EXPECT_EQ(runs[i++].curve.back().transitions, 24);
            }
}

TEST(Experiment, ThreadsDoNotChangeResults) {
    ExperimentOptions options = small_options();
    const std::vector<RunResult> one = without_times(run_all(options));
    options.threads = 3;
    EXPECT_EQ(without_times(run_all(options)), one);
    EXPECT_NE(one[0].choices, one[1].choices) << "seeds should differ";
}

TEST(Experiment, OptionsOfAnEnvironmentKeepItsRunsApart) {
    ExperimentOptions options = small_options();
    options.environments = {"ball-ring(features=relative)", "ball-ring(features=raw)"};
    std::set<std::string> names;
    for (const RunResult& run : run_all(options)) names.insert(run.environment);
    EXPECT_EQ(names, (std::set<std::string>{"ball-ring", "ball-ring(features=relative)"}));
}

TEST(Experiment, ProgressCountsUp) {
    ExperimentOptions options = small_options();
    options.threads = 2;
    Experiment experiment(options);
    std::vector<std::size_t> finished;
    double fraction = 0;
    std::set<std::uint64_t> seeds;
    experiment.run({}, [&](const ExperimentProgress& progress) {
        EXPECT_EQ(progress.runs, 8u);
        EXPECT_GE(progress.fraction, fraction);
        EXPECT_GE(progress.seconds_left, 0);
        fraction = progress.fraction;
        if (progress.latest == nullptr) return;
        finished.push_back(progress.finished);
        seeds.insert(progress.latest->seed);
    });
    EXPECT_EQ(fraction, 1);
    EXPECT_EQ(seeds, (std::set<std::uint64_t>{7, 8}));
    ASSERT_EQ(finished.size(), 8u);
    EXPECT_EQ(finished.back(), 8u);
}

TEST_F(ExperimentTest, FinishedRunsAreNotMadeAgain) {
    const std::vector<RunResult> first = run_all(kept());
    EXPECT_EQ(files(), 8u);
    Experiment again(kept());
    EXPECT_EQ(again.results(), first) << "with the times of the first runs";
    bool called = false;
    EXPECT_EQ(again.run({}, [&](const ExperimentProgress&) { called = true; }), Stop::none);
    EXPECT_FALSE(called);
    EXPECT_EQ(again.results(), first);
}

TEST_F(ExperimentTest, MoreSeedsAndMethodsUseWhatIsThere) {
    const std::vector<RunResult> first = run_all(kept());
    ExperimentOptions more = kept();
    more.seeds = 3;
    more.methods = {"fail-focus", "ees"};
    Experiment experiment(more);
    EXPECT_EQ(experiment.results().size(), 4u);
    EXPECT_EQ(experiment.results()[0], first[0]);
    EXPECT_EQ(experiment.run(), Stop::none);
    EXPECT_EQ(experiment.results().size(), 12u);
}

TEST_F(ExperimentTest, AStoppedExperimentGoesOnToTheSameResults) {
    const std::vector<RunResult> whole = without_times(run_all(small_options()));
    std::stop_source source;
    Budget budget;
    budget.stop_with(source.get_token());
    ExperimentOptions options = kept();
    options.threads = 2;
    {
        Experiment experiment(options);
        const Stop stop = experiment.run(budget, [&](const ExperimentProgress& progress) {
            if (progress.finished == 3) source.request_stop();
        });
        EXPECT_EQ(stop, Stop::interrupted);
        EXPECT_GE(experiment.results().size(), 3u);
        EXPECT_LE(experiment.results().size(), 4u) << "runs that were stopped in the middle are dropped";
        EXPECT_EQ(files(), experiment.results().size());
        for (const RunResult& run : experiment.results()) EXPECT_EQ(run.curve.size(), 3u);
    }
    EXPECT_EQ(without_times(run_all(options)), whole);
}

TEST(Experiment, ABudgetThatIsSpentMakesNoRun) {
    Experiment experiment(small_options());
    Budget budget;
    budget.limit_wall_time(0);
    EXPECT_EQ(experiment.run(budget), Stop::time);
    EXPECT_TRUE(experiment.results().empty());
    EXPECT_EQ(experiment.run(), Stop::none) << "it can be run again";
    EXPECT_EQ(experiment.results().size(), 8u);
}

TEST_F(ExperimentTest, OtherSettingsAreRefused) {
    run_all(kept());
    ExperimentOptions other = kept();
    other.practice.cycles = 3;
    EXPECT_TRUE(contains(refusal(other), "was made with other settings")) << refusal(other);
    EXPECT_TRUE(contains(refusal(other), "cycles=3")) << refusal(other);
}

TEST_F(ExperimentTest, AFailingRunIsNamed) {
    ExperimentOptions options = kept();
    options.practice.competence.model = "none";
    const std::string message = refusal(options);
    EXPECT_TRUE(message.starts_with("light-switch(cells=4), ees, seed 7: there is no competence model"))
        << message;
    EXPECT_EQ(files(), 0u);
}

TEST(Experiment, WrongOptionsAreRefused) {
    const auto refusal_with = [](auto change) {
        ExperimentOptions options = small_options();
        change(options);
        return refusal(options);
    };
    EXPECT_TRUE(contains(refusal_with([](auto& o) { o.methods = {"es"}; }), "there are ees, "));
    EXPECT_TRUE(contains(refusal_with([](auto& o) { o.methods = {"ees", "ees"}; }), "named twice"));
    EXPECT_TRUE(
        contains(refusal_with([](auto& o) { o.environments = {"attic"}; }), "there are light-switch"));
    EXPECT_TRUE(contains(refusal_with([](auto& o) {
                             o.environments = {"light-switch", "light-switch(cells=100)"};
                         }),
                         "'light-switch' is named twice"));
    EXPECT_TRUE(contains(refusal_with([](auto& o) { o.threads = 0; }), "thread"));
    EXPECT_TRUE(contains(refusal_with([](auto& o) { o.practice.cycles = -1; }), "cycles"));
    EXPECT_TRUE(contains(refusal_with([](auto& o) { o.first_seed = ~std::uint64_t{0}; }), "64 bits"));
}

TEST(Experiment, TheFingerprintTellsSettingsApart) {
    const auto with = [](auto change) {
        PracticeOptions options;
        change(options);
        return Experiment::fingerprint("kitchen", options);
    };
    const std::vector<std::string> different = {
        with([](auto&) {}),
        with([](auto& o) { o.cycles = 11; }),
        with([](auto& o) { o.cycle_steps = 3; }),
        with([](auto& o) { o.learn_every = 3; }),
        with([](auto& o) { o.test_every = 3; }),
        with([](auto& o) { o.test_tasks = 3; }),
        with([](auto& o) { o.reset = false; }),
        with([](auto& o) { o.candidates = "all"; }),
        with([](auto& o) { o.bonus = 0.3; }),
        with([](auto& o) { o.sharing = true; }),
        with([](auto& o) { o.competence.model = "beta"; }),
        with([](auto& o) {
            o.competence.prior = {1, 1};
        }),
        with([](auto& o) { o.policy.classifier.kind = "knn"; }),
        with([](auto& o) { o.policy.classifier.hidden = {8}; }),
        with([](auto& o) { o.policy.classifier.steps = 8; }),
        with([](auto& o) { o.policy.features = "all"; }),
        with([](auto& o) { o.policy.epsilon = 0.1; }),
        with([](auto& o) { o.policy.exploration = "uncertain"; }),
        with([](auto& o) { o.planner.search_seconds = 1; }),
        Experiment::fingerprint("light-switch", {}),
        Experiment::fingerprint("light-switch(cells=4)", {}),
    };
    EXPECT_EQ(std::set<std::string>(different.begin(), different.end()).size(), different.size());
    EXPECT_EQ(with([](auto& o) { o.method = "fail-focus"; }), different[0]);
    EXPECT_EQ(with([](auto& o) { o.seed = 4; }), different[0]);
}

TEST(TimeLeft, NothingIsKnownBeforeTheFirstCycle) {
    const TimeLeft time({10, 10});
    EXPECT_TRUE(std::isinf(time.seconds(1)));
    EXPECT_EQ(time.fraction_done(), 0);
    EXPECT_EQ(TimeLeft({0, 0}).seconds(1), 0);
    EXPECT_EQ(TimeLeft({}).fraction_done(), 1);
}

TEST(TimeLeft, CellsHaveSpeedsOfTheirOwn) {
    TimeLeft time({10, 10, 10});
    time.observe(0, 2, 2);   // 8 left, a second each
    time.observe(1, 5, 15);  // 5 left, three seconds each
    EXPECT_DOUBLE_EQ(time.seconds(1), 8 + 15 + 10 * 2) << "the third is expected to be as the mean";
    EXPECT_DOUBLE_EQ(time.seconds(2), 43 / 2.0);
    EXPECT_DOUBLE_EQ(time.fraction_done(), 7 / 30.0);
    time.skip(2, 10);
    EXPECT_DOUBLE_EQ(time.seconds(1), 23);
    EXPECT_DOUBLE_EQ(time.fraction_done(), 7 / 20.0);
}

}  // namespace
}  // namespace praxis::practice
