#include "search/ground/condition.hpp"

#include <algorithm>
#include <utility>

namespace praxis::grounding {
namespace {

Condition constant(bool value) {
    Condition condition;
    condition.kind = value ? Condition::Kind::truth : Condition::Kind::falsity;
    return condition;
}

/// Joins parts under `kind`; `unit` is its neutral element, `zero` its absorbing one.
Condition join(Condition::Kind kind, Condition::Kind unit, Condition::Kind zero,
               std::vector<Condition> parts) {
    Condition result;
    result.kind = kind;
    for (Condition& part : parts) {
        if (part.kind == unit) continue;
        if (part.kind == zero) return std::move(part);
        if (part.kind == kind)
            std::move(part.children.begin(), part.children.end(), std::back_inserter(result.children));
        else
            result.children.push_back(std::move(part));
    }
    if (result.children.empty()) return constant(unit == Condition::Kind::truth);
    if (result.children.size() == 1) {
        Condition only = std::move(result.children.front());
        return only;
    }
    return result;
}

Condition normalise_equality(const Formula& formula, bool negate) {
    const Term a = formula.terms[0];
    const Term b = formula.terms[1];
    if (a == b) return constant(!negate);
    if (!a.is_variable() && !b.is_variable()) return constant(negate);
    Condition result;
    result.kind = Condition::Kind::equality;
    result.negated = negate;
    result.terms = {a, b};
    return result;
}

std::vector<Condition> normalise_all(const std::vector<Formula>& formulas, bool negate) {
    std::vector<Condition> result;
    result.reserve(formulas.size());
    for (const Formula& formula : formulas) result.push_back(normalise(formula, negate));
    return result;
}

/// For exists: conjunctions whose disjunction is the condition; for forall: the dual. The condition itself if
/// there would be too many.
std::vector<Condition> multiplied_out(Condition::Kind kind, const Condition& condition) {
    using Kind = Condition::Kind;
    constexpr std::size_t kMost = 8;
    const Kind outer = kind == Kind::exists ? Kind::disjunction : Kind::conjunction;
    const Kind inner = kind == Kind::exists ? Kind::conjunction : Kind::disjunction;
    std::vector<Condition> result;
    if (condition.kind == outer) {
        for (const Condition& child : condition.children)
            for (Condition& part : multiplied_out(kind, child)) result.push_back(std::move(part));
    } else if (condition.kind == inner) {
        result.push_back(constant(inner == Kind::conjunction));
        for (const Condition& child : condition.children) {
            const std::vector<Condition> parts = multiplied_out(kind, child);
            if (result.size() * parts.size() > kMost) return {condition};
            std::vector<Condition> next;
            for (const Condition& left : result)
                for (const Condition& right : parts)
                    next.push_back(inner == Kind::conjunction ? conjunction({left, right})
                                                              : disjunction({left, right}));
            result = std::move(next);
        }
    } else {
        return {condition};
    }
    return result;
}

/// `exists` splits over `or`, `forall` over `and`. So that each part can be joined by its own atoms, a child
/// that mixes both is first multiplied out while that stays small: exists z (a and (b or c)) is looked up as
/// two joins.
Condition quantify(Condition::Kind kind, const std::vector<std::uint32_t>& variables, Condition child) {
    using Kind = Condition::Kind;
    if (child.kind == kind) {
        std::vector<std::uint32_t> all = variables;
        all.insert(all.end(), child.variables.begin(), child.variables.end());
        Condition inner = std::move(child.children.front());
        return quantify(kind, all, std::move(inner));
    }
    std::vector<Condition> parts = multiplied_out(kind, child);
    if (parts.size() > 1) {
        for (Condition& part : parts) part = quantify(kind, variables, std::move(part));
        return kind == Kind::exists ? disjunction(std::move(parts)) : conjunction(std::move(parts));
    }
    Condition result;
    result.kind = kind;
    result.variables = variables;
    result.children.push_back(std::move(child));
    return result;
}

void collect_free(const Condition& condition, std::vector<std::uint32_t>& bound,
                  std::vector<std::uint32_t>& free) {
    for (Term term : condition.terms)
        if (term.is_variable() && std::find(bound.begin(), bound.end(), term.variable_index()) == bound.end())
            free.push_back(term.variable_index());
    const std::size_t outer = bound.size();
    bound.insert(bound.end(), condition.variables.begin(), condition.variables.end());
    for (const Condition& child : condition.children) collect_free(child, bound, free);
    bound.resize(outer);
}

}  // namespace

Condition conjunction(std::vector<Condition> parts) {
    using Kind = Condition::Kind;
    return join(Kind::conjunction, Kind::truth, Kind::falsity, std::move(parts));
}

Condition disjunction(std::vector<Condition> parts) {
    using Kind = Condition::Kind;
    return join(Kind::disjunction, Kind::falsity, Kind::truth, std::move(parts));
}

Condition normalise(const Formula& formula, bool negate) {
    switch (formula.kind) {
        case Connective::truth:
            return constant(!negate);
        case Connective::falsity:
            return constant(negate);
        case Connective::equality:
            return normalise_equality(formula, negate);
        case Connective::negation:
            return normalise(formula.children.front(), !negate);
        case Connective::atom: {
            Condition result;
            result.kind = Condition::Kind::literal;
            result.negated = negate;
            result.predicate = formula.predicate;
            result.terms = formula.terms;
            return result;
        }
        case Connective::conjunction:
        case Connective::disjunction: {
            auto parts = normalise_all(formula.children, negate);
            const bool conjunctive = (formula.kind == Connective::conjunction) != negate;
            return conjunctive ? conjunction(std::move(parts)) : disjunction(std::move(parts));
        }
        case Connective::implication: {
            std::vector<Condition> parts;
            parts.push_back(normalise(formula.children[0], !negate));
            parts.push_back(normalise(formula.children[1], negate));
            return negate ? conjunction(std::move(parts)) : disjunction(std::move(parts));
        }
        case Connective::existential:
        case Connective::universal: {
            const bool existential = (formula.kind == Connective::existential) != negate;
            return quantify(existential ? Condition::Kind::exists : Condition::Kind::forall,
                            formula.variables, normalise(formula.children.front(), negate));
        }
    }
    return constant(!negate);
}

std::span<const Condition> conjuncts(const Condition& condition) {
    if (condition.kind == Condition::Kind::truth) return {};
    if (condition.kind == Condition::Kind::conjunction) return condition.children;
    return {&condition, 1};
}

std::vector<std::uint32_t> free_variables(const Condition& condition) {
    std::vector<std::uint32_t> bound;
    std::vector<std::uint32_t> free;
    collect_free(condition, bound, free);
    std::sort(free.begin(), free.end());
    free.erase(std::unique(free.begin(), free.end()), free.end());
    return free;
}

}  // namespace praxis::grounding
