// Which certified atoms a condition relies on, in a state of the symbolic task.
//
// A positive certified atom is relied on. A derived atom that must hold is followed into the axiom that makes
// it hold; one that must not ("unsafe") into every instance of its axioms that only certified atoms keep from
// holding, and then the state's atoms that make the instance matter are the reason ("because"): were they not
// there, nothing would be relied on.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/task.hpp"
#include "search/validate/condition.hpp"
#include "search/validate/executor.hpp"
#include "tamp/refine/tuple_map.hpp"

namespace praxis::tamp {

/// Predicate, objects.
using GroundAtom = Tuple;

struct Support {
    GroundAtom atom;                  ///< certified
    std::vector<GroundAtom> because;  ///< atoms of the state for which it is needed
    bool choice = false;              ///< another atom might have served instead
};

/// Knows the conditions of a task. Immutable.
class SupportRules {
  public:
    /// `certified`: by predicate. Throws UnsupportedError for derived predicates that depend on themselves
    /// and on certified atoms.
    SupportRules(const LiftedTask& task, const std::vector<bool>& certified);

    struct Rule {
        const Axiom* axiom;
        validation::Condition body;
        validation::Condition relaxed;  ///< what depends on certified atoms negatively is taken to hold
    };

    const LiftedTask& task() const { return task_; }
    bool certified(PredicateId predicate) const { return certified_[predicate.index()]; }
    /// Certified, or derived from what is.
    bool touches(PredicateId predicate) const { return touches_[predicate.index()]; }
    bool touches(const validation::Condition& condition) const;
    const std::vector<Rule>& rules(PredicateId predicate) const { return rules_[predicate.index()]; }
    const validation::Condition& precondition(SchemaId schema) const {
        return preconditions_[schema.index()];
    }
    const validation::Condition& goal() const { return goal_; }
    /// A condition, with atoms that are certified (or depend on that) and must not hold left out.
    validation::Condition relaxed(const validation::Condition& condition) const;

  private:
    void refuse_recursion() const;

    const LiftedTask& task_;
    std::vector<bool> certified_;
    std::vector<bool> touches_;
    std::vector<std::vector<Rule>> rules_;  ///< by predicate
    std::vector<validation::Condition> preconditions_;
    validation::Condition goal_;
};

/// What the precondition of a step relies on, in the executor's state, where it holds; appended to
/// `supports`.
void find_supports(const SupportRules& rules, validation::Executor& state, const PlanStep& step,
                   std::vector<Support>& supports);
/// The same for the goal.
void find_goal_supports(const SupportRules& rules, validation::Executor& state,
                        std::vector<Support>& supports);

}  // namespace praxis::tamp
