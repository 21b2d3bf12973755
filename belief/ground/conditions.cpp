#include "belief/ground/conditions.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "search/ground/refuse.hpp"

namespace praxis::belief {
namespace {

using Verdict = Conditions::Verdict;

Verdict opposite(Verdict verdict) {
    switch (verdict) {
        case Verdict::fails:
            return Verdict::holds;
        case Verdict::holds:
            return Verdict::fails;
        case Verdict::open:
            break;
    }
    return Verdict::open;
}

/// The verdict on a disjunction (`decisive` is holds) or conjunction (fails), part by part.
class Junction {
  public:
    explicit Junction(Verdict decisive) : decisive_(decisive), verdict_(opposite(decisive)) {}
    bool decided() const { return verdict_ == decisive_; }
    Verdict verdict() const { return verdict_; }
    void add(Verdict part) {
        if (part == decisive_ || (part == Verdict::open && !decided())) verdict_ = part;
    }

  private:
    Verdict decisive_, verdict_;
};

bool is_disjunctive(Connective kind) {
    return kind == Connective::disjunction || kind == Connective::existential;
}

bool bound(const std::vector<Term>& terms, const Conditions::Binding& binding) {
    return std::all_of(terms.begin(), terms.end(), [&](const Term& term) {
        return !term.is_variable() || binding[term.variable_index()].valid();
    });
}

}  // namespace

Conditions::Conditions(std::shared_ptr<const ContingentTask> source,
                       std::shared_ptr<const FiniteDomainTask> ground, std::shared_ptr<const AtomIndex> atoms)
    : source_(std::move(source)), ground_(std::move(ground)), atoms_(std::move(atoms)) {}

void Conditions::refuse(Location where, std::string message) const {
    grounding::refuse(*source_->task, where, std::move(message));
}

std::vector<ObjectId> Conditions::resolve(const std::vector<Term>& terms, const Binding& binding) {
    std::vector<ObjectId> result;
    result.reserve(terms.size());
    for (const Term& term : terms)
        result.push_back(term.is_variable() ? binding[term.variable_index()] : term.object_id());
    return result;
}

Conditions::Binding Conditions::bind(const Scope& scope, std::span<const ObjectId> arguments) {
    Binding binding(scope.variable_types.size());
    std::copy(arguments.begin(), arguments.end(), binding.begin());
    return binding;
}

Place Conditions::place(PredicateId predicate, std::span<const ObjectId> arguments) const {
    std::uint32_t number = atoms_->find(predicate, arguments);
    if (number == AtomIndex::kAbsent) return {Place::Kind::never, {}};
    if ((*atoms_)[number].kind != AtomIndex::Entry::Kind::fact) return {Place::Kind::always, {}};
    // Of several variables that have the atom, one with two values can be uncertain.
    const std::uint32_t first = number;
    for (; number != AtomIndex::kAbsent; number = (*atoms_)[number].next)
        if (ground_->domain_sizes[static_cast<std::size_t>((*atoms_)[number].fact.variable)] == 2)
            return {Place::Kind::fact, (*atoms_)[number].fact};
    return {Place::Kind::fact, (*atoms_)[first].fact};
}

Place Conditions::place(const GroundLiteral& literal) const {
    Place result = place(literal.predicate, literal.arguments);
    if (!literal.negated) return result;
    switch (result.kind) {
        case Place::Kind::always:
            return {Place::Kind::never, {}};
        case Place::Kind::never:
            return {Place::Kind::always, {}};
        case Place::Kind::fact:
            break;
    }
    if (ground_->domain_sizes[static_cast<std::size_t>(result.fact.variable)] != 2)
        refuse(literal.where, "a negative literal about an atom that is one of several values");
    result.fact.value = 1 - result.fact.value;
    return result;
}

Conditions::Verdict Conditions::verdict(const Formula& formula, const Scope& scope, const Binding& binding,
                                        const Context& context) const {
    switch (formula.kind) {
        case Connective::truth:
            return Verdict::holds;
        case Connective::falsity:
            return Verdict::fails;
        case Connective::equality: {
            if (!bound(formula.terms, binding)) return Verdict::open;
            const std::vector<ObjectId> equal = resolve(formula.terms, binding);
            return equal[0] == equal[1] ? Verdict::holds : Verdict::fails;
        }
        case Connective::negation:
            return opposite(verdict(formula.children[0], scope, binding, context));
        case Connective::implication: {
            Junction either(Verdict::holds);
            either.add(opposite(verdict(formula.children[0], scope, binding, context)));
            if (!either.decided()) either.add(verdict(formula.children[1], scope, binding, context));
            return either.verdict();
        }
        case Connective::conjunction:
        case Connective::disjunction: {
            Junction parts(is_disjunctive(formula.kind) ? Verdict::holds : Verdict::fails);
            for (const Formula& child : formula.children) {
                parts.add(verdict(child, scope, binding, context));
                if (parts.decided()) break;
            }
            return parts.verdict();
        }
        case Connective::existential:
        case Connective::universal: {
            Junction parts(is_disjunctive(formula.kind) ? Verdict::holds : Verdict::fails);
            Binding inner = binding;
            const auto visit = [&](const auto& self, std::size_t next) -> void {
                if (next == formula.variables.size())
                    return parts.add(verdict(formula.children[0], scope, inner, context));
                for (ObjectId object : objects(scope, formula.variables[next])) {
                    inner[formula.variables[next]] = object;
                    self(self, next + 1);
                    if (parts.decided()) return;
                }
            };
            visit(visit, 0);
            return parts.verdict();
        }
        case Connective::atom:
            break;
    }
    if (!bound(formula.terms, binding)) return Verdict::open;
    const Place where = place(formula.predicate, resolve(formula.terms, binding));
    if (where.kind != Place::Kind::fact)
        return where.kind == Place::Kind::always ? Verdict::holds : Verdict::fails;
    const std::int32_t value = context[static_cast<std::size_t>(where.fact.variable)];
    if (value == kOpen) return Verdict::open;
    return value == where.fact.value ? Verdict::holds : Verdict::fails;
}

Dnf Conditions::dnf(const Formula& formula, const Scope& scope, const Binding& binding,
                    const Context& context, bool negated) const {
    const Verdict known = verdict(formula, scope, binding, context);
    if (known != Verdict::open) return (known == Verdict::holds) != negated ? Dnf::always() : Dnf::never();
    const auto joined = [&](bool disjunctive, const auto& for_each_part) {
        Dnf result = disjunctive ? Dnf::never() : Dnf::always();
        for_each_part([&](const Dnf& part) { result = disjunctive ? result | part : result & part; });
        return result;
    };
    switch (formula.kind) {
        case Connective::negation:
            return dnf(formula.children[0], scope, binding, context, !negated);
        case Connective::implication:
            return joined(!negated, [&](const auto& add) {
                add(dnf(formula.children[0], scope, binding, context, !negated));
                add(dnf(formula.children[1], scope, binding, context, negated));
            });
        case Connective::conjunction:
        case Connective::disjunction:
            return joined(is_disjunctive(formula.kind) != negated, [&](const auto& add) {
                for (const Formula& child : formula.children)
                    add(dnf(child, scope, binding, context, negated));
            });
        case Connective::existential:
        case Connective::universal:
            return joined(is_disjunctive(formula.kind) != negated, [&](const auto& add) {
                Binding inner = binding;
                const auto visit = [&](const auto& self, std::size_t next) -> void {
                    if (next == formula.variables.size())
                        return add(dnf(formula.children[0], scope, inner, context, negated));
                    for (ObjectId object : objects(scope, formula.variables[next])) {
                        inner[formula.variables[next]] = object;
                        self(self, next + 1);
                    }
                };
                visit(visit, 0);
            });
        default:
            break;
    }
    const Fact fact = place(formula.predicate, resolve(formula.terms, binding)).fact;
    if (ground_->derived(fact.variable))
        refuse(formula.where, "a sensing model that depends on a derived predicate");
    return negated ? negation(Dnf::of(fact), sizes()) : Dnf::of(fact);
}

}  // namespace praxis::belief
