#include "parser/check/contingent/static_condition.hpp"

#include <algorithm>

namespace praxis::check {

const Formula* StaticConditions::find_changing(const Formula& formula, const LiftedTask& task) {
    if (formula.kind == Connective::atom) {
        const Predicate& predicate = task.predicates[formula.predicate.index()];
        return predicate.fluent || predicate.derived ? &formula : nullptr;
    }
    for (const Formula& child : formula.children) {
        if (const Formula* found = find_changing(child, task)) return found;
    }
    return nullptr;
}

bool StaticConditions::holds(const Formula& formula, const Scope& scope, std::vector<ObjectId>& binding) {
    const auto child_holds = [&](const Formula& child) { return holds(child, scope, binding); };
    switch (formula.kind) {
        case Connective::truth:
            return true;
        case Connective::falsity:
            return false;
        case Connective::atom:
            tuple_.clear();
            for (const Term term : formula.terms) tuple_.push_back(object_of(term, binding));
            return initial_atoms_[formula.predicate.index()].find(tuple_) != TupleIndex::kNone;
        case Connective::equality:
            return object_of(formula.terms[0], binding) == object_of(formula.terms[1], binding);
        case Connective::negation:
            return !child_holds(formula.children[0]);
        case Connective::conjunction:
            return std::all_of(formula.children.begin(), formula.children.end(), child_holds);
        case Connective::disjunction:
            return std::any_of(formula.children.begin(), formula.children.end(), child_holds);
        case Connective::implication:
            return !child_holds(formula.children[0]) || child_holds(formula.children[1]);
        case Connective::existential:
            return !for_each_binding(formula.variables, scope, binding,
                                     [&] { return !child_holds(formula.children[0]); });
        case Connective::universal:
            return for_each_binding(formula.variables, scope, binding,
                                    [&] { return child_holds(formula.children[0]); });
    }
    return false;
}

}  // namespace praxis::check
