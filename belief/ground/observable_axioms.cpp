#include "belief/ground/observable_axioms.hpp"

#include <set>
#include <utility>
#include <vector>

#include "belief/ground/observables.hpp"

namespace praxis::belief {
namespace {

Formula compound(Connective kind, std::vector<Formula> children) {
    Formula result;
    result.kind = kind;
    result.children = std::move(children);
    return result;
}

/// Moves all variables up by `by`, and notes those that are used.
class Shift {
  public:
    explicit Shift(std::uint32_t by) : by_(by) {}

    std::uint32_t operator()(std::uint32_t variable) {
        used_.insert(variable + by_);
        return variable + by_;
    }
    Term operator()(const Term& term) {
        return term.is_variable() ? Term::variable((*this)(term.variable_index())) : term;
    }
    Formula operator()(Formula formula) {
        for (Term& term : formula.terms) term = (*this)(term);
        for (Formula& child : formula.children) child = (*this)(std::move(child));
        for (std::uint32_t& variable : formula.variables) {
            variable += by_;
            used_.erase(variable);
        }
        return formula;
    }
    /// The free ones.
    std::vector<std::uint32_t> used() const { return {used_.begin(), used_.end()}; }

  private:
    std::uint32_t by_;
    std::set<std::uint32_t> used_;
};

class Writer {
  public:
    explicit Writer(const ContingentTask& source)
        : source_(source), task_(*source.task), asked_(find_observables(source).asked) {
        rules_.resize(asked_.size());
    }

    LiftedTask operator()() {
        for (std::size_t s = 0; s < source_.sensing.size(); ++s)
            collect(source_.sensing[s].model, task_.schemas[s].scope);
        collect(source_.default_model, source_.default_scope);
        for (std::size_t p = 0; p < asked_.size(); ++p)
            if (asked_[p]) derive(PredicateId(p));
        return std::move(task_);
    }

  private:
    struct Rule {
        const SensingRule* rule;
        const Scope* scope;
    };

    void collect(const std::vector<SensingRule>& rules, const Scope& scope) {
        for (const SensingRule& rule : rules) rules_[rule.predicate.index()].push_back({&rule, &scope});
    }

    /// An atom holds where a rule that makes it true applies; or, where there are none, no rule at all.
    void derive(PredicateId predicate) {
        task_.predicates[predicate.index()].derived = true;
        std::vector<Rule> positive, negative;
        for (const Rule& rule : rules_[predicate.index()])
            (rule.rule->value ? positive : negative).push_back(rule);
        for (const Rule& rule : positive) {
            Axiom axiom = head(predicate);
            axiom.body = applies(rule, axiom.scope);
            task_.axioms.push_back(std::move(axiom));
        }
        if (!positive.empty() || negative.empty()) return;
        Axiom axiom = head(predicate);
        std::vector<Formula> none;
        for (const Rule& rule : negative)
            none.push_back(compound(Connective::negation, {applies(rule, axiom.scope)}));
        axiom.body = compound(Connective::conjunction, std::move(none));
        task_.axioms.push_back(std::move(axiom));
    }

    Axiom head(PredicateId predicate) const {
        Axiom axiom;
        axiom.predicate = predicate;
        const std::vector<TypeId>& types = task_.predicates[predicate.index()].parameters;
        axiom.scope.variable_types = types;
        for (std::size_t i = 0; i < types.size(); ++i)
            axiom.scope.variable_names.push_back("?x" + std::to_string(i));
        axiom.scope.parameter_count = static_cast<std::uint32_t>(types.size());
        return axiom;
    }

    /// Some instance of the rule applies that is about the atom of the axiom's parameters.
    Formula applies(const Rule& rule, Scope& scope) const {
        Shift shift(static_cast<std::uint32_t>(scope.variable_types.size()));
        for (std::size_t i = 0; i < rule.scope->variable_types.size(); ++i) {
            scope.variable_types.push_back(rule.scope->variable_types[i]);
            scope.variable_names.push_back(rule.scope->variable_names[i]);
        }
        std::vector<Formula> parts{shift(rule.rule->condition)};
        for (std::size_t i = 0; i < rule.rule->terms.size(); ++i) {
            Formula same;
            same.kind = Connective::equality;
            same.terms = {Term::variable(i), shift(rule.rule->terms[i])};
            parts.push_back(std::move(same));
        }
        Formula result = compound(Connective::existential, {compound(Connective::conjunction, parts)});
        result.variables = shift.used();
        return result.variables.empty() ? result.children.front() : result;
    }

    const ContingentTask& source_;
    LiftedTask task_;
    std::vector<bool> asked_;
    std::vector<std::vector<Rule>> rules_;  ///< by predicate
};

}  // namespace

LiftedTask with_observable_axioms(const ContingentTask& task) {
    return Writer(task)();
}

}  // namespace praxis::belief
