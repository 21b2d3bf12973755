#include "search/ground/ground_condition.hpp"

#include <algorithm>
#include <utility>

namespace praxis::grounding {
namespace {

using Kind = Condition::Kind;

/// Inside a disjunction: how many conjunctions one alternative may bring in.
constexpr std::size_t kMostPerAlternative = 8;
/// Removing implied conjunctions is quadratic; larger disjunctions are left as they are.
constexpr std::size_t kMostForSubsumption = 64;

std::int32_t code(Term term) {
    return term.is_variable() ? static_cast<std::int32_t>(term.variable_index())
                              : ~static_cast<std::int32_t>(term.object_id().index());
}

Object value(std::int32_t term, const Object* binding) {
    return term >= 0 ? binding[term] : static_cast<Object>(~term);
}

/// Cheap and decisive conditions first.
int rank(const Condition& condition, const std::vector<bool>& exact) {
    switch (condition.kind) {
        case Kind::equality:
            return 0;
        case Kind::literal:
            return exact[condition.predicate.index()] ? 1 : 2;
        case Kind::conjunction:
        case Kind::disjunction:
            return 3;
        default:
            return 4;
    }
}

}  // namespace

bool tidy(Conjunction& conjunction) {
    std::sort(conjunction.begin(), conjunction.end());
    conjunction.erase(std::unique(conjunction.begin(), conjunction.end()), conjunction.end());
    for (std::size_t i = 1; i < conjunction.size(); ++i)
        if (conjunction[i] == opposite(conjunction[i - 1])) return false;
    return true;
}

void tidy(Disjunction& disjunction) {
    std::sort(disjunction.begin(), disjunction.end(), [](const Conjunction& a, const Conjunction& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    disjunction.erase(std::unique(disjunction.begin(), disjunction.end()), disjunction.end());
    if (!disjunction.empty() && disjunction.front().empty()) disjunction.resize(1);
    if (disjunction.size() > kMostForSubsumption) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < disjunction.size(); ++i) {
        const bool implied =
            std::any_of(disjunction.begin(), disjunction.begin() + static_cast<std::ptrdiff_t>(kept),
                        [&](const Conjunction& shorter) {
                            return std::includes(disjunction[i].begin(), disjunction[i].end(),
                                                 shorter.begin(), shorter.end());
                        });
        if (implied) continue;
        if (kept != i) disjunction[kept] = std::move(disjunction[i]);
        ++kept;
    }
    disjunction.resize(kept);
}

JoinPlan ConditionGrounder::generator_plan(std::span<const Condition> parts, bool negate,
                                           const std::vector<BodyAtom>& more,
                                           const std::vector<std::uint32_t>& variables,
                                           const std::vector<TypeId>& variable_types,
                                           const std::vector<bool>& bound) const {
    Body body;
    body.atoms = more;
    const auto usable = [&](const Condition& part) {
        return std::all_of(part.terms.begin(), part.terms.end(), [&](Term term) {
            return !term.is_variable() || bound[term.variable_index()] ||
                   std::find(variables.begin(), variables.end(), term.variable_index()) != variables.end();
        });
    };
    for (const Condition& part : parts) {
        if (!usable(part)) continue;
        const bool negated = part.negated != negate;
        if (part.kind == Kind::literal && (!negated || exact_[part.predicate.index()]))
            body.atoms.push_back({part.predicate.index(), part.terms, negated});
        else if (part.kind == Kind::equality)
            (negated ? body.unequal : body.equal).emplace_back(part.terms[0], part.terms[1]);
    }
    JoinPlan::Start start;
    start.bound = bound;
    start.needed.assign(variable_types.size(), false);
    for (std::uint32_t variable : variables) start.needed[variable] = true;
    return JoinPlan(relations_, body, variable_types, start);
}

GroundableCondition ConditionGrounder::prepare(const Condition& condition, const std::vector<TypeId>& types,
                                               std::vector<bool> bound) const {
    GroundableCondition result;
    result.kind = condition.kind;
    result.negated = condition.negated;
    for (Term term : condition.terms) result.terms.push_back(code(term));
    if (condition.kind == Kind::literal) result.relation = condition.predicate.index();
    if (condition.kind == Kind::exists || condition.kind == Kind::forall) {
        const Condition& child = condition.children.front();
        const bool universal = condition.kind == Kind::forall;
        const Kind inner = universal ? Kind::disjunction : Kind::conjunction;
        const auto parts = child.kind == inner ? std::span<const Condition>(child.children)
                                               : std::span<const Condition>(&child, 1);
        result.plan = generator_plan(parts, universal, {}, condition.variables, types, bound);
        for (std::uint32_t variable : condition.variables) bound[variable] = true;
    }
    std::vector<const Condition*> children;
    for (const Condition& child : condition.children) children.push_back(&child);
    std::stable_sort(children.begin(), children.end(), [&](const Condition* a, const Condition* b) {
        return rank(*a, exact_) < rank(*b, exact_);
    });
    for (const Condition* child : children) result.children.push_back(prepare(*child, types, bound));
    return result;
}

ConditionGrounder::Known ConditionGrounder::look_up(RelationId relation, const Object* tuple,
                                                    AtomId& atom) const {
    const Row row = relations_[relation].find(tuple);
    if (row == kNoRow) return Known::no;
    if (exact_[relation]) return Known::yes;
    atom = task_.first_atom[relation] + row;
    return task_.constant[atom] ? Known::yes : Known::open;
}

ConditionGrounder::Known ConditionGrounder::evaluate(const GroundableCondition& literal,
                                                     const Object* binding, AtomId& atom) {
    Known known;
    if (literal.kind == Kind::equality) {
        known = value(literal.terms[0], binding) == value(literal.terms[1], binding) ? Known::yes : Known::no;
    } else {
        tuple_.resize(std::max(tuple_.size(), literal.terms.size()));
        for (std::size_t i = 0; i < literal.terms.size(); ++i) tuple_[i] = value(literal.terms[i], binding);
        known = look_up(literal.relation, tuple_.data(), atom);
    }
    if (!literal.negated || known == Known::open) return known;
    return known == Known::yes ? Known::no : Known::yes;
}

bool ConditionGrounder::add(const GroundableCondition& condition, Object* binding, Conjunction& literals,
                            Factors& factors) {
    switch (condition.kind) {
        case Kind::truth:
            return true;
        case Kind::falsity:
            return false;
        case Kind::literal:
        case Kind::equality: {
            AtomId atom = 0;
            const Known known = evaluate(condition, binding, atom);
            if (known == Known::open) literals.push_back(condition.negated ? negative(atom) : positive(atom));
            return known != Known::no;
        }
        case Kind::conjunction:
            return std::all_of(
                condition.children.begin(), condition.children.end(),
                [&](const GroundableCondition& child) { return add(child, binding, literals, factors); });
        case Kind::forall: {
            bool possible = true;
            const bool whole = condition.plan.run(relations_, binding, kNoRow, [&] {
                possible = add(condition.children.front(), binding, literals, factors);
                return possible;
            });
            if (!whole && possible) stopped_ = true;
            return possible;
        }
        case Kind::disjunction:
        case Kind::exists:
            return add_disjunction(condition, binding, literals, factors);
    }
    return true;
}

bool ConditionGrounder::add_alternative(const GroundableCondition& condition, Object* binding,
                                        Disjunction& alternatives) {
    Conjunction literals;
    Factors factors;
    if (!add(condition, binding, literals, factors)) return true;
    if (stopped_) return false;
    const bool certain = literals.empty() && factors.empty();
    multiply_out(std::move(literals), std::move(factors), kMostPerAlternative, alternatives);
    return !certain;
}

bool ConditionGrounder::add_disjunction(const GroundableCondition& condition, Object* binding,
                                        Conjunction& literals, Factors& factors) {
    Disjunction alternatives;
    bool open = true;  // no alternative is certain so far
    if (condition.kind == Kind::exists) {
        const bool whole = condition.plan.run(relations_, binding, kNoRow, [&] {
            open = add_alternative(condition.children.front(), binding, alternatives);
            return open;
        });
        if (!whole && open) stopped_ = true;
    } else {
        for (const GroundableCondition& child : condition.children) {
            open = add_alternative(child, binding, alternatives);
            if (!open) break;
        }
    }
    if (!open) return true;
    if (alternatives.empty()) return false;
    tidy(alternatives);
    if (alternatives.front().empty()) return true;
    if (alternatives.size() == 1)
        literals.insert(literals.end(), alternatives.front().begin(), alternatives.front().end());
    else if (alternatives.size() == 2 && alternatives[0].size() == 1 && alternatives[1].size() == 1 &&
             alternatives[0][0] == opposite(alternatives[1][0]))
        return true;
    else
        factors.push_back(std::move(alternatives));
    return true;
}

void ConditionGrounder::multiply_out(Conjunction literals, Factors factors, std::size_t most,
                                     Disjunction& result) {
    std::sort(factors.begin(), factors.end());
    factors.erase(std::unique(factors.begin(), factors.end()), factors.end());
    std::stable_sort(factors.begin(), factors.end(),
                     [](const Disjunction& a, const Disjunction& b) { return a.size() < b.size(); });
    Disjunction product{std::move(literals)};
    for (Disjunction& factor : factors) {
        if (product.size() * factor.size() > most) {
            const Literal literal = positive(auxiliary(std::move(factor)));
            for (Conjunction& conjunction : product) conjunction.push_back(literal);
            continue;
        }
        Disjunction next;
        next.reserve(product.size() * factor.size());
        for (const Conjunction& left : product)
            for (const Conjunction& right : factor) {
                next.push_back(left);
                next.back().insert(next.back().end(), right.begin(), right.end());
            }
        product = std::move(next);
    }
    for (Conjunction& conjunction : product)
        if (tidy(conjunction)) result.push_back(std::move(conjunction));
}

void ConditionGrounder::ground(const GroundableCondition& condition, Object* binding, std::size_t most,
                               Disjunction& result) {
    result.clear();
    Conjunction literals;
    Factors factors;
    if (!add(condition, binding, literals, factors) || stopped_) return;
    multiply_out(std::move(literals), std::move(factors), most, result);
    tidy(result);
}

AtomId ConditionGrounder::auxiliary(Disjunction disjunction) {
    tidy(disjunction);
    const auto [found, fresh] = auxiliaries_.try_emplace(std::move(disjunction), task_.atom_count);
    if (fresh) {
        ++task_.atom_count;
        task_.derived.push_back(true);
        task_.initial.push_back(false);
        task_.constant.push_back(false);
        for (const Conjunction& body : found->first) {
            task_.heads.push_back(found->second);
            task_.bodies.append(body);
        }
    }
    return found->second;
}

}  // namespace praxis::grounding
