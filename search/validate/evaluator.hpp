// Decides conditions in a state and enumerates their solutions.
//
// Enumeration is a backtracking join. The conditions still to be met are a list; those whose variables all
// have values are tested, then the one with the fewest matching tuples (known from the index) supplies
// values: an atom its tuples, a disjunction each of its branches, an existential its inside. Only where
// nothing supplies values is a variable run through its type. As soon as all variables that the caller wants
// have values, the rest is a mere existence question and ends with its first answer.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "parser/task.hpp"
#include "search/validate/condition.hpp"
#include "search/validate/fact_table.hpp"

namespace praxis::validation {

class Evaluator {
  public:
    static constexpr std::uint32_t kUnbound = std::numeric_limits<std::uint32_t>::max();

    /// Called for a solution; the values are in `value(variable)`. True ends the enumeration.
    using Sink = std::function<bool()>;

    /// Keeps references to both.
    Evaluator(const LiftedTask& task, std::vector<FactTable>& tables);

    /// Starts afresh with the variables of a scope, none of them bound.
    void enter(const Scope& scope);
    void bind(std::uint32_t variable, std::uint32_t object) { values_[variable] = object; }
    std::uint32_t value(std::uint32_t variable) const { return values_[variable]; }
    std::uint32_t value(Term term) const {
        return term.is_variable() ? values_[term.variable_index()] : term.object_id().index();
    }

    /// Binds the atom's variables to the tuple; false, with some of them bound, if it does not fit.
    bool unify(const Condition& atom, const std::uint32_t* tuple);
    /// False if one of the variables has an empty type.
    bool inhabited(std::span<const std::uint32_t> variables) const;
    /// The truth of a condition whose free variables are bound.
    bool holds(const Condition& condition);
    /// Enumerates the values of `wanted` (distinct variables; those already bound keep their value) for which
    /// all `conditions` hold. A solution may come more than once. `known`, if given, is asked for each
    /// candidate first; true skips it.
    void enumerate(std::span<const Condition* const> conditions, std::span<const std::uint32_t> wanted,
                   const Sink& sink, const Sink* known = nullptr);

  private:
    /// What one enumeration is after; no sink: existence.
    struct Query {
        std::span<const std::uint32_t> wanted;
        const Sink* sink = nullptr;
        const Sink* known = nullptr;
    };

    bool bound(const Condition& condition) const;
    bool test_atom(const Condition& condition);
    bool exists(const Condition& quantified);
    std::uint32_t domain_size(std::uint32_t variable) const;
    bool admits(std::uint32_t variable, std::uint32_t object) const;
    /// The table's positions that have values, which are left in `key_`.
    std::uint32_t bound_positions(const Condition& atom);
    /// How many values the condition would supply; kUnbound: it cannot.
    std::uint32_t estimate(const Condition& condition);

    /// Solves the pending conditions from `begin` to the end of the stack; true ends the enumeration.
    bool solve(std::size_t begin, const Query& query);
    bool solve_existence(std::size_t begin);
    /// Tests and drops the pending conditions that are bound; false if one fails.
    bool reduce(std::size_t begin);
    bool supply(const Condition& condition, std::size_t begin, const Query& query);
    bool supply_atom(const Condition& atom, std::size_t begin, const Query& query);
    bool supply_row(const Condition& atom, std::uint32_t row, std::size_t begin, const Query& query);
    bool supply_equality(const Condition& equality, std::size_t begin, const Query& query);
    bool supply_type(std::uint32_t variable, std::size_t begin, const Query& query);
    /// Solves a copy of the pending conditions from `begin`, and `extra` if it is given.
    bool descend(std::size_t begin, const Condition* extra, const Query& query);
    void undo(std::size_t mark);

    const LiftedTask& task_;
    std::vector<FactTable>& tables_;
    const Scope* scope_ = nullptr;
    std::vector<std::uint32_t> values_;      ///< by variable of the scope
    std::vector<std::uint32_t> trail_;       ///< variables bound by the enumeration, to be undone
    std::vector<const Condition*> pending_;  ///< a stack of lists
    std::vector<std::uint32_t> key_;         ///< scratch for one tuple
};

}  // namespace praxis::validation
