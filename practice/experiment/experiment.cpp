#include "practice/experiment/experiment.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "parser/diagnostic.hpp"
#include "practice/environments/environments.hpp"
#include "practice/experiment/time_left.hpp"
#include "practice/loop/run_practice.hpp"
#include "practice/loop/settings_text.hpp"
#include "practice/methods/method.hpp"
#include "search/text/output.hpp"

namespace praxis::practice {

namespace {

using Clock = std::chrono::steady_clock;

void check_methods(const std::vector<std::string>& names) {
    std::string known;
    std::set<std::string> all, seen;
    for (const MethodInfo& method : methods()) {
        known += (known.empty() ? "" : ", ") + method.name;
        all.insert(method.name);
    }
    for (const std::string& name : names) {
        if (!all.contains(name))
            throw std::invalid_argument("there is no method '" + name + "'; there are " + known);
        if (!seen.insert(name).second)
            throw std::invalid_argument("the method '" + name + "' is named twice");
    }
}

void check(const ExperimentOptions& options) {
    check_methods(options.methods);
    if (options.threads < 1) throw std::invalid_argument("an experiment needs a thread at least");
    if (options.practice.cycles < 0) throw std::invalid_argument("cycles must not be negative");
    if (options.seeds > 0 &&
        options.first_seed > std::numeric_limits<std::uint64_t>::max() - (options.seeds - 1))
        throw std::invalid_argument("the last seed does not fit into 64 bits");
}

std::string name_of(const RunKey& key) {
    return key.environment + ", " + key.method + ", seed " + std::to_string(key.seed) + ": ";
}

/// Throws the exception that is being handled again, with the run's name in front.
[[noreturn]] void rethrow_with(const std::string& name) {
    try {
        throw;
    } catch (const UnsupportedError& error) {
        throw UnsupportedError(name + error.what());
    } catch (const InputError& error) {
        throw InputError(name + error.what());
    } catch (const OutputError& error) {
        throw OutputError(name + error.what());
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + error.what());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw std::runtime_error(name + error.what());
    }
}

/// Seconds since the last call.
class Stopwatch {
  public:
    double lap() {
        const auto now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

  private:
    Clock::time_point start_ = Clock::now();
};

}  // namespace

struct Experiment::Implementation {
    struct Place {
        std::string name;
        std::unique_ptr<SimulatedEnvironment> environment;
        std::optional<RunStore> store;
    };

    explicit Implementation(ExperimentOptions given) : options(std::move(given)) {
        check(options);
        std::set<std::string> names;
        for (const std::string& expression : options.environments) {
            Place place{canonical_environment(expression), make_environment(expression), {}};
            if (!names.insert(place.name).second)
                throw std::invalid_argument("the environment '" + place.name + "' is named twice");
            if (!options.results.empty())
                place.store.emplace(options.results, fingerprint(place.name, options.practice));
            places.push_back(std::move(place));
        }
        runs.resize(places.size() * options.methods.size() * options.seeds);
        load();
    }

    RunKey key(std::size_t index) const {
        const std::size_t cell = index / options.seeds;
        return {places[cell / options.methods.size()].name, options.methods[cell % options.methods.size()],
                options.first_seed + index % options.seeds};
    }
    Place& place(std::size_t index) { return places[index / options.seeds / options.methods.size()]; }
    /// Of a run: the test before any practice counts as one.
    double cycles() const { return options.practice.cycles + 1; }

    void load() {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const std::optional<RunStore>& store = place(i).store;
            if (!store || !store->contains(key(i))) continue;
            runs[i] = store->load(key(i));
            ++finished;
        }
    }

    /// The places of the runs that are missing, seeds in the outer loop.
    std::vector<std::size_t> missing() const {
        std::vector<std::size_t> result;
        const std::size_t cells = options.seeds == 0 ? 0 : runs.size() / options.seeds;
        for (std::size_t seed = 0; seed < options.seeds; ++seed)
            for (std::size_t cell = 0; cell < cells; ++cell)
                if (const std::size_t index = cell * options.seeds + seed; !runs[index])
                    result.push_back(index);
        return result;
    }

    /// One call of `Experiment::run`.
    struct Work {
        const Budget& budget;
        const OnProgress& on_progress;
        std::vector<std::size_t> queue;
        TimeLeft time_left;
        std::size_t next = 0;
        std::stop_source stop = {};
        Stop reason = Stop::none;
        std::exception_ptr failure = nullptr;
        std::mutex telling = {};  // taken before `mutex`
    };

    Stop run(const Budget& budget, const OnProgress& on_progress) {
        std::vector<std::size_t> queue = missing();
        std::vector<double> left(places.size() * options.methods.size(), 0);
        for (const std::size_t index : queue) left[index / options.seeds] += cycles();
        Work work{budget, on_progress, std::move(queue), TimeLeft(std::move(left))};
        {
            const std::stop_callback forward(budget.stop_token(), [&] { work.stop.request_stop(); });
            std::vector<std::jthread> threads;
            if (!work.queue.empty()) tell(work, nullptr);
            const std::size_t count = std::min(static_cast<std::size_t>(options.threads), work.queue.size());
            for (std::size_t i = 0; i < count; ++i) threads.emplace_back([this, &work] { serve(work); });
        }
        if (work.failure) std::rethrow_exception(work.failure);
        if (finished == runs.size()) return Stop::none;
        if (work.reason != Stop::none) return work.reason;
        const Stop reason = budget.exhausted();
        return reason == Stop::none ? Stop::interrupted : reason;
    }

    void serve(Work& work) {
        try {
            Budget budget = work.budget;
            while (const std::optional<std::size_t> index = take(work, budget))
                practise(work, *index, budget);
        } catch (...) {
            const std::scoped_lock lock(mutex);
            if (!work.failure) work.failure = std::current_exception();
            work.stop.request_stop();
        }
    }

    /// The next run to be made, if there is one and time for it.
    std::optional<std::size_t> take(Work& work, const Budget& budget) {
        look(work, budget);
        const std::scoped_lock lock(mutex);
        if (work.stop.stop_requested() || work.next == work.queue.size()) return std::nullopt;
        return work.queue[work.next++];
    }

    void look(Work& work, const Budget& budget) {
        const Stop reason = budget.exhausted();
        if (reason == Stop::none) return;
        const std::scoped_lock lock(mutex);
        work.reason = reason;
        work.stop.request_stop();
    }

    void practise(Work& work, std::size_t index, const Budget& budget) try {
        const RunKey run_key = key(index);
        const std::size_t cell = index / options.seeds;
        PracticeOptions practice = options.practice;
        practice.method = run_key.method;
        practice.seed = run_key.seed;
        Stopwatch watch;
        int cycle = -1;
        PracticeHooks hooks;
        hooks.stop = work.stop.get_token();
        hooks.on_test = [&](const RunResult& result) {
            look(work, budget);
            const int now = result.curve.back().cycle;
            {
                const std::scoped_lock lock(mutex);
                work.time_left.observe(cell, now - std::exchange(cycle, now), watch.lap());
            }
            tell(work, nullptr);
        };
        RunResult result = run_practice(*place(index).environment, practice, hooks);
        if (work.stop.stop_requested()) return;
        result.environment = run_key.environment;
        if (place(index).store) place(index).store->save(result);
        {
            const std::scoped_lock lock(mutex);
            work.time_left.skip(cell, options.practice.cycles - cycle);
            runs[index] = result;
            ++finished;
        }
        tell(work, &result);
    } catch (...) {
        rethrow_with(name_of(key(index)));
    }

    void tell(Work& work, const RunResult* latest) {
        if (!work.on_progress) return;
        const std::scoped_lock telling(work.telling);
        ExperimentProgress progress;
        {
            const std::scoped_lock lock(mutex);
            progress = {finished, runs.size(), work.time_left.fraction_done(),
                        work.time_left.seconds(
                            std::min(static_cast<std::size_t>(options.threads), runs.size() - finished)),
                        latest};
        }
        work.on_progress(progress);
    }

    ExperimentOptions options;
    std::vector<Place> places;
    mutable std::mutex mutex;  // of what follows, and of Work
    std::vector<std::optional<RunResult>> runs;
    std::size_t finished = 0;
};

Experiment::Experiment(ExperimentOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(options))) {}

Experiment::~Experiment() = default;

Stop Experiment::run(const Budget& budget, const OnProgress& on_progress) {
    return implementation_->run(budget, on_progress);
}

std::vector<RunResult> Experiment::results() const {
    const std::scoped_lock lock(implementation_->mutex);
    std::vector<RunResult> results;
    for (const std::optional<RunResult>& run : implementation_->runs)
        if (run) results.push_back(*run);
    return results;
}

std::size_t Experiment::size() const {
    return implementation_->runs.size();
}

std::string Experiment::fingerprint(const std::string& environment, const PracticeOptions& options) {
    PracticeOptions shared = options;
    shared.method = "any";
    shared.seed = 0;
    const ClassifierOptions& classifier = options.policy.classifier;
    std::ostringstream text;
    text.precision(17);
    text << environment << ": " << settings_text(*make_environment(environment), shared)
         << " cycles=" << options.cycles << " classifier=" << classifier.differences;
    for (const std::size_t units : classifier.hidden) text << ',' << units;
    text << ',' << classifier.steps << ',' << classifier.learning_rate << ',' << classifier.weight_decay
         << ',' << classifier.neighbours << ',' << classifier.members
         << " search_seconds=" << options.planner.search_seconds;
    return text.str();
}

}  // namespace praxis::practice
