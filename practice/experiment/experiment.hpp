// An experiment: methods in environments with seeds, on several threads, kept on disk.
//
//     Experiment experiment({{"ball-ring", "kitchen"}, {"ees", "fail-focus"}});
//     experiment.run();
//     std::cout << report_page(experiment.results(), {});
//
// Each run is made on one thread, and depends on its settings and its seed alone: results do not depend on
// how many threads there are. Seeds come in the outer loop, so that an experiment that is stopped has about
// as many runs of each method. With a directory for results, runs that are finished there are not made again;
// one that is stopped in the middle is dropped, since to make a simulated run again takes no longer than to
// go through its journal.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "practice/experiment/experiment_options.hpp"
#include "practice/experiment/results.hpp"
#include "practice/experiment/run_store.hpp"
#include "search/budget.hpp"

namespace praxis::practice {

struct ExperimentProgress {
    std::size_t finished = 0, runs = 0;
    double fraction = 0;                ///< of all cycles to be made, in [0, 1]
    double seconds_left = 0;            ///< the best estimate; infinite where nothing is known yet
    const RunResult* latest = nullptr;  ///< a run that has just finished, or null
};

class Experiment {
  public:
    /// Makes the environments and loads the runs that are finished. Throws std::invalid_argument for unknown
    /// names, for what is named twice, and for options out of range; InputError for results that are damaged
    /// or were made with other settings; OutputError where the directory cannot be made.
    explicit Experiment(ExperimentOptions options);
    ~Experiment();
    Experiment(const Experiment&) = delete;
    Experiment& operator=(const Experiment&) = delete;

    using OnProgress = std::function<void(const ExperimentProgress&)>;
    /// Makes the runs that are missing; why it ended: Stop::none if all are finished. The budget is looked at
    /// after each test of a run, its stop token after each skill. `on_progress` is called at the start and
    /// after each test, one call at a time, also on the threads of the runs. What a run throws ends the
    /// experiment and comes out here with the run's name in front (lack of memory without it).
    Stop run(const Budget& budget = {}, const OnProgress& on_progress = {});

    /// The finished runs, environment by environment, method by method, by seed. May be called from another
    /// thread while `run` is at work.
    std::vector<RunResult> results() const;
    /// How many runs there are in all.
    std::size_t size() const;

    /// All that the results of an environment depend on, but for method and seed, as a text.
    static std::string fingerprint(const std::string& environment, const PracticeOptions& options);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace praxis::practice
