// Search without grounding, for tasks whose grounding would not fit into memory or time.
//
// A task with many parameters an action may have billions of ground actions, of which a search meets few.
// Here nothing is grounded: a *state* is a set of atoms, which get numbers as they are first met
// (`AtomTable`, `StateStore`); in the state at hand (`Database`) each precondition is asked as a database
// query (`Query`, `QuerySolver`; Corrêa, Pommerening, Helmert and Frances, ICAPS 2020), whose answers are the
// applicable actions (`Actions`), effects under conditions likewise; `Axioms` add what is derived.
//
// Guidance is that of BFWS(f5) (Lipovetzky and Geffner, AAAI 2017; in lifted search Corrêa and Seipp, ICAPS
// 2022). Whenever fewer goals are missing than ever before, a relaxed plan from there (`RelaxedPlan`) gives
// the atoms to make true next. Two queues take turns: one prefers states with new atoms or pairs of atoms
// among those with as many goals missing and as many of those atoms made (`NoveltyTable`), the other states
// with the fewest goals missing and the most atoms made. All this orders and never prunes, so that a search
// that ends without a plan has proved that there is none.
//
// The whole of the lifted task is understood: typing, any formula as precondition, effect condition, goal and
// body of an axiom, universal effects, constants, action costs (which choose among actions between the same
// two states, not among ways). One thread; the same task gives the same plan.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "parser/task.hpp"
#include "search/budget.hpp"
#include "search/engines/search.hpp"
#include "search/plan.hpp"

namespace praxis {

struct LiftedOptions {
    /// Bits of the table that remembers pairs of atoms, a power of two; 0: only single atoms are looked at.
    std::size_t pair_bits = std::size_t{1} << 27;
};

struct LiftedOutcome {
    Status status = Status::failed;  ///< `failed`: `unsupported` says why
    std::optional<Plan> plan;
    SearchStatistics statistics;
    std::string unsupported;  ///< why the task is beyond this search (no stratification of axioms)
};

/// Looks for a plan, the first found being the answer. Throws UnsupportedError for negative costs and costs
/// that do not fit.
LiftedOutcome lifted_search(const LiftedTask& task, const Budget& budget = {},
                            const LiftedOptions& options = {},
                            const std::function<void(const SearchStatistics&)>& on_progress = {});

}  // namespace praxis
