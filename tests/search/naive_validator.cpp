#include "tests/search/naive_validator.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace praxis::test {

namespace {

using Fact = std::pair<std::uint32_t, std::vector<std::uint32_t>>;
using State = std::set<Fact>;
using Values = std::map<std::uint32_t, std::uint32_t>;

struct Naive {
    const LiftedTask& task;

    std::uint32_t value(Term term, const Values& values) const {
        return term.is_variable() ? values.at(term.variable_index()) : term.object_id().index();
    }

    Fact fact(PredicateId predicate, const std::vector<Term>& terms, const Values& values) const {
        Fact result{predicate.index(), {}};
        for (const Term term : terms) result.second.push_back(value(term, values));
        return result;
    }

    /// Calls visit for every assignment of the variables from `i` on; stops when it returns true.
    bool any_assignment(const std::vector<std::uint32_t>& variables, std::size_t i, const Scope& scope,
                        Values& values, const std::function<bool()>& visit) const {
        if (i == variables.size()) return visit();
        for (const ObjectId object : task.types[scope.variable_types[variables[i]].index()].objects) {
            values[variables[i]] = object.index();
            if (any_assignment(variables, i + 1, scope, values, visit)) return true;
        }
        return false;
    }

    bool holds(const Formula& formula, const Scope& scope, Values values, const State& state) const {
        const auto child = [&](std::size_t i) { return holds(formula.children[i], scope, values, state); };
        switch (formula.kind) {
            case Connective::truth:
                return true;
            case Connective::falsity:
                return false;
            case Connective::atom:
                return state.count(fact(formula.predicate, formula.terms, values)) > 0;
            case Connective::equality:
                return value(formula.terms[0], values) == value(formula.terms[1], values);
            case Connective::negation:
                return !child(0);
            case Connective::implication:
                return !child(0) || child(1);
            case Connective::conjunction:
                for (std::size_t i = 0; i < formula.children.size(); ++i) {
                    if (!child(i)) return false;
                }
                return true;
            case Connective::disjunction:
                for (std::size_t i = 0; i < formula.children.size(); ++i) {
                    if (child(i)) return true;
                }
                return false;
            case Connective::existential:
                return any_assignment(formula.variables, 0, scope, values, [&] { return child(0); });
            case Connective::universal:
                return !any_assignment(formula.variables, 0, scope, values, [&] { return !child(0); });
        }
        return false;
    }

    /// Atoms of derived predicates in a formula, with their polarity.
    void dependencies(const Formula& formula, bool positive,
                      std::set<std::pair<std::uint32_t, bool>>& out) const {
        if (formula.kind == Connective::atom) out.insert({formula.predicate.index(), positive});
        for (std::size_t i = 0; i < formula.children.size(); ++i) {
            const bool flips =
                formula.kind == Connective::negation || (formula.kind == Connective::implication && i == 0);
            dependencies(formula.children[i], flips ? !positive : positive, out);
        }
    }

    /// A stratum for every predicate: not below what it uses, above what it uses negated.
    std::vector<std::size_t> strata() const {
        std::vector<std::size_t> level(task.predicates.size(), 0);
        for (std::size_t pass = 0; pass <= task.predicates.size(); ++pass) {
            for (const Axiom& axiom : task.axioms) {
                std::set<std::pair<std::uint32_t, bool>> used;
                dependencies(axiom.body, true, used);
                std::size_t& own = level[axiom.predicate.index()];
                for (const auto& [predicate, positive] : used) {
                    if (!task.predicates[predicate].derived) continue;
                    own = std::max(own, level[predicate] + (positive ? 0 : 1));
                }
            }
        }
        return level;
    }

    State close(State state) const {
        const std::vector<std::size_t> level = strata();
        const std::size_t top = level.empty() ? 0 : *std::max_element(level.begin(), level.end());
        for (std::size_t stratum = 0; stratum <= top; ++stratum) {
            for (bool changed = true; changed;) {
                changed = false;
                for (const Axiom& axiom : task.axioms) {
                    if (level[axiom.predicate.index()] != stratum) continue;
                    std::vector<std::uint32_t> parameters;
                    std::vector<Term> head;
                    for (std::uint32_t i = 0; i < axiom.scope.parameter_count; ++i) {
                        parameters.push_back(i);
                        head.push_back(Term::variable(i));
                    }
                    Values values;
                    any_assignment(parameters, 0, axiom.scope, values, [&] {
                        if (holds(axiom.body, axiom.scope, values, state)) {
                            changed |= state.insert(fact(axiom.predicate, head, values)).second;
                        }
                        return false;
                    });
                }
            }
        }
        return state;
    }
};

}  // namespace

std::size_t naive_failure(const LiftedTask& task, const Plan& plan) {
    const Naive naive{task};
    State state;
    for (std::uint32_t p = 0; p < task.initial_atoms.size(); ++p) {
        for (std::size_t i = 0; i < task.initial_atoms[p].count; ++i) {
            Fact fact{p, {}};
            for (const ObjectId object : task.initial_atoms[p].tuple(i))
                fact.second.push_back(object.index());
            state.insert(fact);
        }
    }
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const State before = naive.close(state);
        const Schema& schema = task.schemas[plan.steps[i].schema.index()];
        Values values;
        for (std::uint32_t a = 0; a < plan.steps[i].arguments.size(); ++a) {
            values[a] = plan.steps[i].arguments[a].index();
        }
        if (!naive.holds(schema.precondition, schema.scope, values, before)) return i + 1;
        State adds;
        State deletes;
        for (const Effect& effect : schema.effects) {
            naive.any_assignment(effect.variables, 0, schema.scope, values, [&] {
                if (naive.holds(effect.condition, schema.scope, values, before)) {
                    (effect.add ? adds : deletes).insert(naive.fact(effect.predicate, effect.terms, values));
                }
                return false;
            });
        }
        for (const Fact& fact : deletes) state.erase(fact);
        state.insert(adds.begin(), adds.end());
    }
    return naive.holds(task.goal, task.goal_scope, {}, naive.close(state)) ? 0 : plan.steps.size() + 1;
}

}  // namespace praxis::test
