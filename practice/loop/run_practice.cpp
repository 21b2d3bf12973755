#include "practice/loop/run_practice.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "practice/loop/journal.hpp"
#include "practice/loop/practice_loop.hpp"
#include "practice/loop/settings_text.hpp"
#include "practice/loop/simulated_world.hpp"
#include "search/thread_time.hpp"

namespace praxis::practice {

namespace {

constexpr std::uint64_t kTestTasks = 4, kTests = 5;

}  // namespace

RunResult run_practice(const SimulatedEnvironment& environment, const PracticeOptions& options,
                       const PracticeHooks& hooks, const std::string& journal_path) {
    SimulatedWorld simulated(environment, options.seed, options.reset);
    std::optional<Journal> journal;
    std::optional<JournaledWorld> journaled;
    if (!journal_path.empty()) {
        journal.emplace(journal_path, settings_text(environment, options));
        journaled.emplace(simulated, *journal);
    }
    World& world = journaled ? static_cast<World&>(*journaled) : simulated;

    RunResult result;
    result.environment = environment.description().name;
    result.method = options.method;
    result.seed = options.seed;
    double start = thread_seconds();
    PracticeLoop loop(environment, world, options);
    std::vector<PracticeTask> tests;
    for (int i = 0; i < options.test_tasks; ++i) {
        Random random = random_stream(options.seed, kTestTasks, static_cast<std::uint64_t>(i));
        tests.push_back(environment.sample_task(random));
    }
    int cycle = 0;
    const auto test = [&] {
        const double practised = thread_seconds();
        result.processor_seconds += practised - start;
        const std::int64_t transitions = loop.learner().transitions();
        int solved = 0;
        for (std::size_t i = 0; i < tests.size(); ++i) {
            Random random = random_stream(random_stream(options.seed, kTests, i).next(), kTests,
                                          static_cast<std::uint64_t>(transitions));
            solved += loop.solves(environment, tests[i], random);
        }
        result.curve.push_back(
            {cycle, transitions,
             tests.empty() ? 0 : static_cast<double>(solved) / static_cast<double>(tests.size())});
        start = thread_seconds();
        result.evaluation_seconds += start - practised;
        if (hooks.on_test) hooks.on_test(result);
    };
    const auto test_if_due = [&] {
        if (loop.learner().transitions() - result.curve.back().transitions >= options.test_every) test();
    };
    test();
    for (cycle = 1; cycle <= options.cycles; ++cycle) {
        if (!loop.run_cycle(hooks.stop,
                            options.test_every > 0 ? std::function<void()>(test_if_due) : nullptr))
            break;
        for (PracticeChoice& choice : loop.method().take_choices())
            result.choices.push_back(std::move(choice));
        if (journal) journal->sync();
        if (result.curve.back().transitions < loop.learner().transitions()) test();
    }
    return result;
}

}  // namespace praxis::practice
