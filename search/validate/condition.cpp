#include "search/validate/condition.hpp"

#include <algorithm>

namespace praxis::validation {

namespace {

using Kind = Condition::Kind;

void find_free(Condition& condition) {
    std::vector<std::uint32_t>& free = condition.free;
    for (const Term term : condition.terms) {
        if (term.is_variable()) free.push_back(term.variable_index());
    }
    for (const Condition& child : condition.children) {
        free.insert(free.end(), child.free.begin(), child.free.end());
    }
    std::sort(free.begin(), free.end());
    free.erase(std::unique(free.begin(), free.end()), free.end());
    std::erase_if(free, [&](std::uint32_t variable) {
        return std::find(condition.variables.begin(), condition.variables.end(), variable) !=
               condition.variables.end();
    });
}

Condition leaf(const Formula& formula, Kind kind, bool negated) {
    Condition result;
    result.kind = kind;
    result.positive = !negated;
    result.predicate = formula.predicate;
    result.terms = formula.terms;
    return result;
}

Condition constant(bool value) {
    Condition result;
    result.kind = value ? Kind::truth : Kind::falsity;
    return result;
}

void append(Condition& parent, Condition child) {
    if (child.kind == parent.kind) {
        std::move(child.children.begin(), child.children.end(), std::back_inserter(parent.children));
    } else {
        parent.children.push_back(std::move(child));
    }
}

Condition list(const Formula& formula, Kind kind, bool negated) {
    Condition result;
    result.kind = kind;
    for (std::size_t i = 0; i < formula.children.size(); ++i) {
        const bool premise = formula.kind == Connective::implication && i == 0;
        append(result, compile(formula.children[i], negated != premise));
    }
    return result;
}

/// A quantifier becomes "there is" its body or "there is no" counterexample; `existential` says which.
Condition quantifier(const Formula& formula, bool existential, bool body_negated) {
    Condition result;
    result.kind = existential ? Kind::exists : Kind::none;
    result.variables = formula.variables;
    Condition child = compile(formula.children.at(0), body_negated);
    if (child.kind == Kind::exists) {
        result.variables.insert(result.variables.end(), child.variables.begin(), child.variables.end());
        Condition inner = std::move(child.children.front());
        child = std::move(inner);
    }
    result.children.push_back(std::move(child));
    return result;
}

Condition shape(const Formula& formula, bool negated) {
    switch (formula.kind) {
        case Connective::truth:
            return constant(!negated);
        case Connective::falsity:
            return constant(negated);
        case Connective::atom:
            return leaf(formula, Kind::atom, negated);
        case Connective::equality:
            return leaf(formula, Kind::equality, negated);
        case Connective::negation:
            return compile(formula.children.at(0), !negated);
        case Connective::conjunction:
            return list(formula, negated ? Kind::any : Kind::all, negated);
        case Connective::disjunction:
        case Connective::implication:
            return list(formula, negated ? Kind::all : Kind::any, negated);
        case Connective::existential:
            return quantifier(formula, !negated, false);
        case Connective::universal:
            return quantifier(formula, negated, true);
    }
    return constant(!negated);
}

}  // namespace

Condition compile(const Formula& formula, bool negated) {
    Condition result = shape(formula, negated);
    result.free.clear();
    find_free(result);
    return result;
}

void collect_predicates(const Condition& condition, std::vector<PredicateId>& out) {
    if (condition.kind == Kind::atom) out.push_back(condition.predicate);
    for (const Condition& child : condition.children) collect_predicates(child, out);
}

}  // namespace praxis::validation
