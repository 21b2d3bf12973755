// The ground planning task in finite-domain representation (SAS+), the one thing that every search reads.
//
// Vocabulary. A *variable* has values 0..domain_size-1. A *fact* is a variable with a value. A *state* assigns a
// value to every variable. *Derived* variables (axiom layer >= 0) are not part of the stored state: before each
// look at a state they are reset to their default value and the axioms are applied, layer by layer, each layer to its
// fixpoint. An *operator* is applicable where its precondition holds; its effects are single assignments, each under its
// own condition (empty: always), all read in the state before. If two effects of one operator set
// the same variable and both fire, the later in the list wins (the grounder orders them so that adds win).
//
// Storage is flat: one array a kind of thing, see PackedLists. The task is immutable once made and may be shared
// between threads. Limits: 2^31 facts, 2^31 operators, 2^32 precondition or effect entries, costs below 2^31.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "parser/rational.hpp"
#include "search/task/ids.hpp"
#include "search/task/names.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis {

/// Variable `variable` has value `value`.
struct Fact {
    std::int32_t variable = 0;
    std::int32_t value = 0;
    friend auto operator<=>(const Fact&, const Fact&) = default;
};

/// Whether all facts are among the values, given by variable.
inline bool all_hold(std::span<const Fact> facts, const std::int32_t* values) {
    for (const Fact& fact : facts) {
        if (values[fact.variable] != fact.value) return false;
    }
    return true;
}

/// Sets `fact` if the condition (list number `condition` of `FiniteDomainTask::conditions`) holds.
struct GroundEffect {
    Fact fact;
    std::uint32_t condition = 0;  ///< 0 is the empty condition
};

/// head := its non-default value, if the body (list of `FiniteDomainTask::axiom_bodies`) holds.
struct GroundAxiom {
    Fact head;
};

struct FiniteDomainTask {
    // Variables.
    std::vector<std::int32_t> domain_sizes;
    std::vector<std::int32_t> axiom_layers;      ///< -1: not derived
    std::vector<std::int32_t> initial_values;    ///< derived variables: the default value
    std::vector<std::uint32_t> first_fact;       ///< number of a variable's value 0 among all facts; size variables + 1
    NameTable fact_names;                        ///< by fact number; words "predicate object ..."
    /// By fact number: how the name reads ("Atom", "NegatedAtom" or "<none of those>", as in SAS+ files).
    enum class FactForm : std::uint8_t { atom, negated_atom, none_of_those };
    std::vector<FactForm> fact_forms;

    // Operators.
    PackedLists<Fact> preconditions;  ///< by operator; sorted by variable, at most one fact a variable
    PackedLists<GroundEffect> effects;  ///< by operator
    PackedLists<Fact> conditions;     ///< effect conditions; conditions[0] is empty; sorted by variable
    std::vector<std::int32_t> costs;  ///< by operator, in units of 1/cost_scale; the real cost, also if `unit_cost`
    NameTable operator_names;         ///< words "schema object ..."

    // Axioms.
    std::vector<GroundAxiom> axioms;
    PackedLists<Fact> axiom_bodies;  ///< by axiom; sorted by variable

    std::vector<Fact> goal;           ///< sorted by variable; empty: every state is a goal
    PackedLists<Fact> mutex_groups;   ///< at most one fact of a group holds (variables themselves not repeated)

    bool unit_cost = true;            ///< no metric: plan cost counts actions (then all `costs` are 1)
    std::int64_t cost_scale = 1;      ///< cost in the PDDL task = cost here / cost_scale
    /// Grounding already proved that there is no plan.
    bool proved_unsolvable = false;

    std::size_t variable_count() const { return domain_sizes.size(); }
    std::size_t operator_count() const { return costs.size(); }
    std::size_t fact_count() const { return first_fact.empty() ? 0 : first_fact.back(); }
    bool derived(std::int32_t variable) const { return axiom_layers[static_cast<std::size_t>(variable)] >= 0; }
    bool has_axioms() const { return !axioms.empty(); }
    bool has_conditional_effects() const { return conditions.size() > 1; }
    std::uint32_t fact_number(Fact fact) const {
        return first_fact[static_cast<std::size_t>(fact.variable)] + static_cast<std::uint32_t>(fact.value);
    }
    /// The fact says that its atom holds, not that it does not or that none of several does.
    bool is_atom(Fact fact) const { return fact_forms[fact_number(fact)] == FactForm::atom; }
    /// "(pick ball1 rooma left)".
    std::string operator_name(OperatorId id) const { return "(" + operator_names.words(id.index()) + ")"; }
    /// "Atom at(truck1, depot0)", "NegatedAtom ...", "<none of those>".
    std::string fact_name(Fact fact) const;
    /// Bytes on the heap.
    std::size_t memory() const;
};

}  // namespace praxis
