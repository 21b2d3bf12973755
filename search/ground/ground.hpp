// Grounding: lifted task in, finite-domain task out.
//
// Phases, each timed: normalise, reach (lifted relaxed reachability as semi-naive Datalog), instantiate,
// simplify, invariants (mutex groups), encode (variables, operators, axioms). See docs/grounding.md.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "parser/task.hpp"
#include "search/budget.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct GroundOptions {
    /// Leave out what cannot matter for the goal. Off: any goal and initial state over the reachable facts
    /// can be posed later.
    bool prune_irrelevant = true;
    /// Wall seconds for the search for invariants; when they are spent, those found so far are used.
    double invariant_seconds = 20;
};

/// What one phase of grounding did.
struct PhaseStatistics {
    std::string name;
    double seconds = 0;           ///< processor time of this thread
    std::size_t peak_memory = 0;  ///< of the process at the end of the phase, bytes
    std::vector<std::pair<std::string, std::size_t>> counts;  ///< "facts", "operators", ...
};

struct GroundResult {
    Stop stop = Stop::none;  ///< not none: the budget ran out and there is no task
    std::shared_ptr<const FiniteDomainTask> task;
    std::vector<PhaseStatistics> phases;
};

/// Throws UnsupportedError where the task uses what cannot be grounded (negative costs, undefined function
/// values, ...).
GroundResult ground(const LiftedTask& task, const GroundOptions& options = {}, const Budget& budget = {});

}  // namespace praxis
