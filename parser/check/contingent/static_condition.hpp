// Formulas over what never changes, evaluated while a task is checked.
#pragma once

#include <optional>
#include <vector>

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

/// Evaluates formulas under bindings of a scope's variables, with the initial atoms as truth.
class StaticConditions {
  public:
    /// `initial_atoms` by predicate.
    StaticConditions(const LiftedTask& task, const std::vector<TupleIndex>& initial_atoms)
        : task_(task), initial_atoms_(initial_atoms) {}

    /// The first atom of the formula whose predicate is derived or changed by an action.
    static const Formula* find_changing(const Formula& formula, const LiftedTask& task);

    /// `binding` has an object for each variable of `scope` that is free in the formula.
    bool holds(const Formula& formula, const Scope& scope, std::vector<ObjectId>& binding);

    static ObjectId object_of(Term term, const std::vector<ObjectId>& binding) {
        return term.is_variable() ? binding[term.variable_index()] : term.object_id();
    }

    /// Calls visit() for every binding of the variables, from `first` on; stops where visit gives false.
    template <class Visit>
    bool for_each_binding(const std::vector<std::uint32_t>& variables, const Scope& scope,
                          std::vector<ObjectId>& binding, Visit visit, std::size_t first = 0) {
        if (first == variables.size()) return visit();
        const std::uint32_t variable = variables[first];
        for (const ObjectId object : task_.types[scope.variable_types[variable].index()].objects) {
            binding[variable] = object;
            if (!for_each_binding(variables, scope, binding, visit, first + 1)) return false;
        }
        return true;
    }

  private:
    const LiftedTask& task_;
    const std::vector<TupleIndex>& initial_atoms_;
    std::vector<ObjectId> tuple_;
};

}  // namespace praxis::check
