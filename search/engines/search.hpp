// One search, asked and answered in ground terms. Session puts PDDL around it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "search/budget.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Which search to run: an expression such as "lazy_greedy([ff()],preferred=[ff()])".
struct Configuration {
    std::string expression;
    std::uint64_t seed = 0;
    int threads = 1;
};

/// The configuration behind a name ("agile", ...). Throws std::invalid_argument with the names there are.
Configuration alias(const std::string& name);
/// An expression as a configuration; the expression is checked here. Throws std::invalid_argument with place
/// and mend.
Configuration configuration(const std::string& expression);

enum class Status : std::uint8_t {
    solved,            ///< there is a plan
    unsolvable_early,  ///< proved before search (exit code 10)
    unsolvable,        ///< proved by search (11)
    failed,            ///< searched in vain, without a proof (12)
    out_of_memory,     ///< (22)
    out_of_time,       ///< (23)
    interrupted,       ///< by the stop token
};

/// The status of a search that a budget has stopped.
Status status_of(Stop stop);

/// Numbers a search reports, while it runs and at its end.
struct SearchStatistics {
    double seconds = 0;  ///< wall time of the search so far
    std::uint64_t expanded = 0, evaluated = 0, generated = 0, reopened = 0, dead_ends = 0;
    std::uint64_t registered_states = 0;
    double bytes_per_state = 0;                 ///< packed state, duplicate set and search node together
    std::size_t peak_memory = 0;                ///< of the process, bytes
    std::optional<std::int32_t> best_estimate;  ///< lowest heuristic value seen

    /// Adds what another search counted.
    void add_counts(const SearchStatistics& other);
};

/// What to search for: a plan from `initial_values` (by variable; derived ones at their default) to `goal`.
struct Query {
    std::vector<std::int32_t> initial_values;
    std::vector<Fact> goal;
};

/// The query the task itself poses.
Query task_query(const FiniteDomainTask& task);

struct Outcome {
    Status status = Status::failed;
    std::optional<std::vector<OperatorId>> plan;
    std::int64_t cost = 0;  ///< of the plan, by `FiniteDomainTask::costs`
    bool optimal = false;   ///< the search proved that no plan is cheaper
    /// There is no plan below the bound that the search was given (`optimal` says so of a plan).
    bool no_cheaper_plan = false;
    SearchStatistics statistics;
};

struct SearchCallbacks {
    /// Each better plan, as found.
    std::function<void(std::span<const OperatorId> plan, std::int64_t cost)> on_plan;
    std::function<void(const SearchStatistics&)> on_progress;
};

/// A task with the structures that every search over it shares (successor generator, axiom evaluator, state
/// packing), made once. Immutable after construction; may be used by several searches on several threads at
/// once.
class PreparedTask {
  public:
    /// If the budget runs out, `stop` says so, and so does every search.
    explicit PreparedTask(std::shared_ptr<const FiniteDomainTask> task, const Budget& budget = {});
    ~PreparedTask();
    PreparedTask(PreparedTask&&) noexcept;
    PreparedTask& operator=(PreparedTask&&) noexcept;

    const FiniteDomainTask& task() const;
    /// Why the preparation was not finished; Stop::none if it was.
    Stop stop() const;
    struct Parts;
    const Parts& parts() const { return *parts_; }

  private:
    std::unique_ptr<const Parts> parts_;
};

/// Runs the search that the configuration describes. Throws std::invalid_argument if the expression is wrong.
Outcome search(const PreparedTask& prepared, const Query& query, const Configuration& configuration,
               const Budget& budget = {}, const SearchCallbacks& callbacks = {});

}  // namespace praxis
