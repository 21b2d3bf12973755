#include "tests/search/support/naive_semantics.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace praxis::test {

namespace {

std::uint32_t value(Term term, const NaiveSemantics::Tuple& values) {
    return term.is_variable() ? values[term.variable_index()] : term.object_id().index();
}

/// Predicates in a formula, with their polarity.
void collect_atoms(const Formula& formula, bool positive, std::set<std::pair<std::uint32_t, bool>>& out) {
    if (formula.kind == Connective::atom) out.insert({formula.predicate.index(), positive});
    for (std::size_t i = 0; i < formula.children.size(); ++i) {
        const bool flips =
            formula.kind == Connective::negation || (formula.kind == Connective::implication && i == 0);
        collect_atoms(formula.children[i], flips != positive, out);
    }
}

}  // namespace

NaiveSemantics::NaiveSemantics(const LiftedTask& task) : task_(task), first_{0} {
    for (const Predicate& predicate : task.predicates) {
        std::size_t tuples = 1;
        for (std::size_t i = 0; i < predicate.parameters.size(); ++i) tuples *= task.objects.size();
        first_.push_back(first_.back() + tuples);
    }
    find_strata();
}

/// Not below what a predicate uses, above what it uses negated.
void NaiveSemantics::find_strata() {
    stratum_.assign(task_.predicates.size(), 0);
    for (std::size_t pass = 0; pass <= task_.predicates.size(); ++pass) {
        for (const Axiom& axiom : task_.axioms) {
            std::set<std::pair<std::uint32_t, bool>> used;
            collect_atoms(axiom.body, true, used);
            std::size_t& own = stratum_[axiom.predicate.index()];
            for (const auto& [predicate, positive] : used) {
                if (!task_.predicates[predicate].derived) continue;
                own = std::max(own, stratum_[predicate] + (positive ? 0 : 1));
            }
        }
    }
}

std::size_t NaiveSemantics::atom(PredicateId predicate, std::span<const std::uint32_t> arguments) const {
    std::size_t number = 0;
    for (const std::uint32_t argument : arguments) number = number * task_.objects.size() + argument;
    return first_[predicate.index()] + number;
}

std::size_t NaiveSemantics::atom(PredicateId predicate, const std::vector<Term>& terms,
                                 const Tuple& values) const {
    std::size_t number = 0;
    for (const Term term : terms) number = number * task_.objects.size() + value(term, values);
    return first_[predicate.index()] + number;
}

std::string NaiveSemantics::atom_name(std::size_t atom) const {
    const auto next = std::upper_bound(first_.begin(), first_.end(), atom);
    const auto predicate = static_cast<std::size_t>(next - first_.begin()) - 1;
    std::string arguments;
    std::size_t number = atom - first_[predicate];
    for (std::size_t i = 0; i < task_.predicates[predicate].parameters.size(); ++i) {
        arguments = " " + task_.objects[number % task_.objects.size()].name + arguments;
        number /= task_.objects.size();
    }
    return task_.predicates[predicate].name + arguments;
}

NaiveSemantics::State NaiveSemantics::initial() const {
    State state(atom_count(), false);
    Tuple arguments;
    for (std::size_t p = 0; p < task_.initial_atoms.size(); ++p) {
        for (std::size_t i = 0; i < task_.initial_atoms[p].count; ++i) {
            arguments.clear();
            for (const ObjectId object : task_.initial_atoms[p].tuple(i)) arguments.push_back(object.index());
            state[atom(PredicateId(p), arguments)] = true;
        }
    }
    close(state);
    return state;
}

void NaiveSemantics::close(State& state) const {
    for (std::size_t p = 0; p < task_.predicates.size(); ++p) {
        if (!task_.predicates[p].derived) continue;
        for (std::size_t a = first_[p]; a < first_[p + 1]; ++a) state[a] = false;
    }
    if (task_.axioms.empty()) return;
    const std::size_t top = *std::max_element(stratum_.begin(), stratum_.end());
    for (std::size_t stratum = 0; stratum <= top; ++stratum) {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Axiom& axiom : task_.axioms) {
                if (stratum_[axiom.predicate.index()] != stratum) continue;
                instances(axiom.scope, [&](const Tuple& arguments) {
                    const std::size_t head = atom(axiom.predicate, arguments);
                    if (state[head]) return;
                    Tuple values = values_for(axiom.scope, arguments);
                    if (holds(axiom.body, axiom.scope, values, state)) state[head] = changed = true;
                });
            }
        }
    }
}

bool NaiveSemantics::goal(const State& state) const {
    Tuple values = values_for(task_.goal_scope, {});
    return holds(task_.goal, task_.goal_scope, values, state);
}

NaiveSemantics::Tuple NaiveSemantics::values_for(const Scope& scope, const Tuple& arguments) const {
    Tuple values = arguments;
    values.resize(scope.variable_types.size());
    return values;
}

/// Calls visit for every assignment of the variables from `i` on; stops when it returns true.
bool NaiveSemantics::any_assignment(const std::vector<std::uint32_t>& variables, std::size_t i,
                                    const Scope& scope, Tuple& values,
                                    const std::function<bool()>& visit) const {
    if (i == variables.size()) return visit();
    for (const ObjectId object : task_.types[scope.variable_types[variables[i]].index()].objects) {
        values[variables[i]] = object.index();
        if (any_assignment(variables, i + 1, scope, values, visit)) return true;
    }
    return false;
}

void NaiveSemantics::instances(const Scope& scope, const std::function<void(const Tuple&)>& visit) const {
    std::vector<std::uint32_t> parameters(scope.parameter_count);
    for (std::uint32_t i = 0; i < scope.parameter_count; ++i) parameters[i] = i;
    Tuple values(scope.parameter_count);
    any_assignment(parameters, 0, scope, values, [&] {
        visit(values);
        return false;
    });
}

bool NaiveSemantics::holds(const Formula& formula, const Scope& scope, Tuple& values,
                           const State& state) const {
    const auto child = [&](const Formula& inner) { return holds(inner, scope, values, state); };
    const std::vector<Formula>& children = formula.children;
    switch (formula.kind) {
        case Connective::truth:
            return true;
        case Connective::falsity:
            return false;
        case Connective::atom:
            return state[atom(formula.predicate, formula.terms, values)];
        case Connective::equality:
            return value(formula.terms[0], values) == value(formula.terms[1], values);
        case Connective::negation:
            return !child(children[0]);
        case Connective::implication:
            return !child(children[0]) || child(children[1]);
        case Connective::conjunction:
            return std::all_of(children.begin(), children.end(), child);
        case Connective::disjunction:
            return std::any_of(children.begin(), children.end(), child);
        case Connective::existential:
            return any_assignment(formula.variables, 0, scope, values, [&] { return child(children[0]); });
        case Connective::universal:
            return !any_assignment(formula.variables, 0, scope, values, [&] { return !child(children[0]); });
    }
    return false;
}

bool NaiveSemantics::applicable(const Schema& schema, const Tuple& arguments, const State& state) const {
    Tuple values = values_for(schema.scope, arguments);
    return holds(schema.precondition, schema.scope, values, state);
}

NaiveSemantics::State NaiveSemantics::successor(const Schema& schema, const Tuple& arguments,
                                                const State& state) const {
    State next = state;
    Tuple values = values_for(schema.scope, arguments);
    for (const bool add : {false, true}) {
        for (const Effect& effect : schema.effects) {
            if (effect.add != add) continue;
            any_assignment(effect.variables, 0, schema.scope, values, [&] {
                if (holds(effect.condition, schema.scope, values, state))
                    next[atom(effect.predicate, effect.terms, values)] = add;
                return false;
            });
        }
    }
    close(next);
    return next;
}

std::optional<Rational> NaiveSemantics::cost(const Schema& schema, const Tuple& arguments) const {
    const std::optional<Rational> cost = schema.cost ? evaluate(*schema.cost, arguments) : Rational(0);
    if (!cost) return std::nullopt;
    return task_.minimize_cost ? cost : Rational(1);
}

std::optional<Rational> NaiveSemantics::evaluate(const Expression& expression, const Tuple& values) const {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::constant) return expression.value;
    if (expression.kind == Kind::function) {
        const FunctionTable& table = task_.initial_values[expression.function.index()];
        for (std::size_t i = 0; i < table.tuples.count; ++i) {
            bool same = true;
            for (std::size_t c = 0; c < expression.terms.size(); ++c)
                same = same && table.tuples.tuple(i)[c].index() == value(expression.terms[c], values);
            if (same) return table.values[i];
        }
        return std::nullopt;
    }
    std::optional<Rational> result;
    for (const Expression& child : expression.children) {
        const std::optional<Rational> next = evaluate(child, values);
        if (!next) return std::nullopt;
        if (!result)
            result = expression.kind == Kind::negate ? -*next : *next;
        else if (expression.kind == Kind::add)
            result = *result + *next;
        else if (expression.kind == Kind::subtract)
            result = *result - *next;
        else
            result = expression.kind == Kind::multiply ? *result * *next : *result / *next;
    }
    return result;
}

}  // namespace praxis::test
