// The ground contingent task: operators, what is uncertain about the state, and what can be read of it.
//
// Vocabulary. The *physical* task is the finite-domain task of the true world: its operators change the true
// state, whatever anybody knows. A variable is *uncertain* if there may be a moment at which its value is not
// known; all others are *certain*. Every uncertain variable that is not derived has two values, so that
// knowing its atom true, knowing it false and not knowing it are all there is. A *reading* tells whether a
// fact holds. A *sensor* is passive: wherever its condition holds, its reading comes by itself. *Clauses* and
// *groups* speak about the first state.
//
// Immutable once made; may be shared between threads.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "belief/ground/dnf.hpp"
#include "parser/contingent.hpp"
#include "search/atom_index.hpp"
#include "search/budget.hpp"
#include "search/plan_names.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis::belief {

/// A variable as the index of what there is of it.
inline std::size_t index(std::int32_t variable) {
    return static_cast<std::size_t>(variable);
}

/// Tells whether `fact` holds.
struct GroundReading {
    Fact fact;
    double accuracy = 1;  ///< probability of a right answer
};

struct GroundSensor {
    std::string name;  ///< "(smell p1-1)"
    GroundReading reading;
};

/// `fact` holds where the condition does, and only there: a variable that sensing models need.
struct GroundDefinition {
    Fact fact;
    Dnf condition;

    /// Gives the variable its value in a state.
    void settle(std::int32_t* state) const {
        state[fact.variable] = condition.holds(state) ? fact.value : 1 - fact.value;
    }
};

struct BeliefTask {
    std::shared_ptr<const ContingentTask> source;
    /// The lifted task that was grounded: the source's with what grounding needed besides.
    Task lifted;
    std::shared_ptr<const FiniteDomainTask> physical;
    /// Where the atoms of `lifted` are.
    std::shared_ptr<const AtomIndex> atoms;

    std::vector<bool> uncertain;               ///< by variable
    std::vector<std::int32_t> initial_values;  ///< by variable; kUnknown where it is not known
    static constexpr std::int32_t kUnknown = -1;

    PackedLists<GroundReading> readings;  ///< by operator: what it tells about the state after it
    PackedLists<std::int32_t> forgotten;  ///< by operator: variables whose values it leaves open
    /// By variable: knowledge of it lasts this many actions (`:decay`); kForever otherwise.
    std::vector<std::int64_t> lasting;
    static constexpr std::int64_t kForever = -1;
    std::vector<GroundSensor> sensors;
    PackedLists<Fact> sensor_conditions;  ///< by sensor

    PackedLists<Fact> clauses;  ///< of each, one fact or more holds at first
    PackedLists<Fact> groups;   ///< of each, one fact at most holds at first
    /// By clause and by group: it holds in every state, not only in the first one.
    std::vector<bool> invariant_clauses, invariant_groups;
    /// Multi-valued variables that some action leaves open: of each, exactly one fact holds in every state.
    PackedLists<Fact> choices;
    /// Clauses say the same; effects keep it so.
    std::vector<GroundDefinition> definitions;
    /// Definitions of helper variables, which are of no meaning but in the first state. They come first.
    std::vector<GroundDefinition> first_definitions;
    PackedLists<Fact> worlds;  ///< hidden worlds of the source: the uncertain atoms that hold

    std::size_t operator_count() const { return physical->operator_count(); }
    void add_clause(std::span<const Fact> facts, bool invariant) {
        clauses.append(facts);
        invariant_clauses.push_back(invariant);
    }
    void add_group(std::span<const Fact> facts, bool invariant) {
        groups.append(facts);
        invariant_groups.push_back(invariant);
    }
};

struct GroundBeliefResult {
    Stop stop = Stop::none;  ///< not none: the budget ran out and there is no task
    std::shared_ptr<const BeliefTask> task;
};

/// Grounds a contingent task. Throws UnsupportedError for what cannot be grounded or planned for, and
/// InputError where the initial description contradicts itself.
GroundBeliefResult ground_belief(std::shared_ptr<const ContingentTask> source, const Budget& budget = {});

}  // namespace praxis::belief
