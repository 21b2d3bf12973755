#include "search/ground/rules.hpp"

#include <algorithm>
#include <utility>

namespace praxis::grounding {
namespace {

/// More rules than this for one condition, and a disjunction becomes a helper relation.
constexpr std::size_t kMostAlternatives = 16;

bool any_empty(const std::vector<Body>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.empty(); });
}

void add_variables(Term term, std::vector<std::uint32_t>& variables) {
    if (term.is_variable()) variables.push_back(term.variable_index());
}

void sort_unique(std::vector<std::uint32_t>& items) {
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Variables that the positive atoms (and equalities with them) give values to.
std::vector<std::uint32_t> generated_variables(const Body& body) {
    std::vector<std::uint32_t> variables;
    for (const BodyAtom& atom : body.atoms)
        if (!atom.negated)
            for (Term term : atom.terms) add_variables(term, variables);
    bool grown = true;
    const auto has = [&](Term term) {
        return !term.is_variable() ||
               std::find(variables.begin(), variables.end(), term.variable_index()) != variables.end();
    };
    while (std::exchange(grown, false)) {
        for (const auto& [a, b] : body.equal) {
            if (has(a) == has(b)) continue;
            add_variables(has(a) ? b : a, variables);
            grown = true;
        }
    }
    sort_unique(variables);
    return variables;
}

std::vector<std::uint32_t> all_variables(const Body& body) {
    std::vector<std::uint32_t> variables;
    for (const BodyAtom& atom : body.atoms)
        for (Term term : atom.terms) add_variables(term, variables);
    for (const auto* pairs : {&body.equal, &body.unequal})
        for (const auto& [a, b] : *pairs) add_variables(a, variables), add_variables(b, variables);
    sort_unique(variables);
    return variables;
}

std::vector<std::uint32_t> intersection(const std::vector<std::uint32_t>& a,
                                        const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> result;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

/// The body without the checks that mention the variables dropped.
Body restricted(const Body& body, const std::vector<std::uint32_t>& dropped) {
    const auto mentions = [&](Term term) {
        return term.is_variable() &&
               std::binary_search(dropped.begin(), dropped.end(), term.variable_index());
    };
    Body result;
    for (const BodyAtom& atom : body.atoms)
        if (std::none_of(atom.terms.begin(), atom.terms.end(), mentions)) result.atoms.push_back(atom);
    for (const auto& pair : body.equal)
        if (!mentions(pair.first) && !mentions(pair.second)) result.equal.push_back(pair);
    for (const auto& pair : body.unequal)
        if (!mentions(pair.first) && !mentions(pair.second)) result.unequal.push_back(pair);
    return result;
}

}  // namespace

std::vector<Body> RuleMaker::alternatives(const Condition& condition, const std::vector<TypeId>& types) {
    using Kind = Condition::Kind;
    switch (condition.kind) {
        case Kind::truth:
            return {Body{}};
        case Kind::falsity:
            return {};
        case Kind::literal: {
            Body body;
            if (!condition.negated || exact_[condition.predicate.index()])
                body.atoms.push_back({condition.predicate.index(), condition.terms, condition.negated});
            else
                relaxed_ = true;
            return {std::move(body)};
        }
        case Kind::equality: {
            Body body;
            (condition.negated ? body.unequal : body.equal)
                .emplace_back(condition.terms[0], condition.terms[1]);
            return {std::move(body)};
        }
        case Kind::conjunction: {
            std::vector<std::vector<Body>> parts;
            for (const Condition& child : condition.children) {
                parts.push_back(alternatives(child, types));
                if (parts.back().empty()) return {};
            }
            return conjunction_of(std::move(parts), types);
        }
        case Kind::disjunction: {
            std::vector<Body> result;
            for (const Condition& child : condition.children)
                for (Body& body : alternatives(child, types)) result.push_back(std::move(body));
            if (any_empty(result)) return {Body{}};
            return result;
        }
        case Kind::exists: {
            std::vector<Body> parts = alternatives(condition.children.front(), types);
            if (parts.empty()) return {};
            for (std::uint32_t variable : condition.variables)
                if (relations_.task().types[types[variable].index()].objects.empty()) return {};
            return helper(parts, free_variables(condition), types);
        }
        case Kind::forall:
            relaxed_ = true;
            return {Body{}};
    }
    return {Body{}};
}

std::vector<Body> RuleMaker::conjunction_of(std::vector<std::vector<Body>> parts,
                                            const std::vector<TypeId>& types) {
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
    std::vector<Body> result(1);
    for (std::vector<Body>& part : parts) {
        if (result.size() * part.size() > kMostAlternatives) {
            std::vector<std::uint32_t> outer;
            for (const Body& body : part)
                for (std::uint32_t variable : all_variables(body)) outer.push_back(variable);
            sort_unique(outer);
            part = helper(part, outer, types);
        }
        std::vector<Body> next;
        next.reserve(result.size() * part.size());
        for (const Body& left : result)
            for (const Body& right : part) {
                next.push_back(left);
                next.back().add(right);
            }
        result = std::move(next);
    }
    return result;
}

std::vector<Body> RuleMaker::helper(const std::vector<Body>& parts, const std::vector<std::uint32_t>& outer,
                                    const std::vector<TypeId>& types) {
    std::vector<std::uint32_t> columns = outer;
    for (const Body& part : parts) columns = intersection(columns, generated_variables(part));
    relaxed_ |= columns.size() != outer.size();
    std::vector<Body> kept;
    for (const Body& part : parts) {
        std::vector<std::uint32_t> loose;
        const auto generated = generated_variables(part);
        std::set_difference(outer.begin(), outer.end(), generated.begin(), generated.end(),
                            std::back_inserter(loose));
        kept.push_back(restricted(part, loose));
        if (kept.back().empty()) return {Body{}};
    }
    std::vector<TypeId> column_types;
    std::vector<Term> terms;
    for (std::uint32_t variable : columns) {
        column_types.push_back(types[variable]);
        terms.push_back(Term::variable(variable));
    }
    const RelationId relation = relations_.add(column_types, true);
    for (Body& part : kept) {
        Rule rule;
        rule.head = relation;
        rule.head_terms = terms;
        rule.body = std::move(part);
        rule.variable_types = &types;
        rules_.push_back(std::move(rule));
    }
    Body body;
    body.atoms.push_back({relation, std::move(terms), false});
    return {std::move(body)};
}

}  // namespace praxis::grounding
