// What the agent knows: of every physical fact, that it holds, that it does not, or neither.
//
// Knowledge of the present is kept as values of the compiled task (so that a search can start from it at
// once), and knowledge of the first state beside it: a reading of a variable that no action has touched since
// tells about the first state, and by its clauses about other variables. Of components that are tracked, all
// possible cases are kept.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "belief/cases.hpp"
#include "belief/compilation.hpp"
#include "belief/derived_knowledge.hpp"
#include "belief/initial_knowledge.hpp"
#include "belief/percept.hpp"
#include "search/engines/random.hpp"
#include "search/state/axiom_evaluator.hpp"

namespace praxis::belief {

class Belief {
  public:
    /// What is known at first.
    explicit Belief(std::shared_ptr<const Compilation> compilation);

    const Compilation& compilation() const { return *compilation_; }
    const std::shared_ptr<const Compilation>& shared_compilation() const { return compilation_; }
    /// The initial description has a model as far as deduction can tell.
    bool consistent() const { return consistent_; }

    /// By compiled variable, the derived ones included.
    const std::vector<std::int32_t>& values() const { return values_; }
    /// The known value of a physical variable, or BeliefTask::kUnknown.
    std::int32_t value(std::int32_t variable) const;
    /// The physical fact is known to hold.
    bool knows(Fact fact) const { return value(fact.variable) == fact.value; }
    bool knows(std::span<const Fact> facts) const;
    Truth truth(Fact fact) const;
    /// The action's precondition is known to hold.
    bool can(std::uint32_t action) const { return knows(physical().preconditions[action]); }
    bool goal_known() const { return knows(physical().goal); }
    /// An action may have changed the variable since the start.
    bool touched(std::int32_t variable) const { return touched_[static_cast<std::size_t>(variable)]; }
    /// Tells beliefs apart (up to chance).
    std::uint64_t fingerprint() const;

    /// What is known after an action whose precondition holds, before it is seen what came of it.
    void act(std::uint32_t action);
    /// A reading without error: `fact` holds now. Returns false, and changes nothing, if that contradicts
    /// what is known.
    bool learn(Fact fact);
    /// Nothing is known of the variable any more; not for tracked ones.
    void forget(std::int32_t variable);

    /// Makes `values` ready for a plan that starts now: puts possible cases into the slots of the compiled
    /// task, all of them or a random choice with those that made a plan fail before.
    void begin_plan(Random& random);
    /// A plan has come to an action that is not known to be possible: remembers a case where it is not.
    void remember_exception(std::uint32_t action);

  private:
    const FiniteDomainTask& physical() const { return *compilation_->belief().physical; }
    std::size_t basic(std::int32_t variable) const {
        return static_cast<std::size_t>(compilation_->variable(variable));
    }
    void complete();
    void decay();
    /// A reading of a variable that an action may have changed.
    bool learn_now(Fact fact);

    std::shared_ptr<const Compilation> compilation_;
    std::shared_ptr<const AxiomEvaluator> axioms_;
    AxiomEvaluator::Scratch scratch_;
    InitialKnowledge initial_;
    InitialKnowledge invariants_;  ///< what holds in all states
    DerivedKnowledge derived_;
    bool consistent_ = true;
    std::vector<bool> touched_;  ///< by physical variable: an action may have changed it
    std::vector<std::int32_t> values_;
    std::vector<Cases> cases_;                          ///< by component
    std::vector<std::vector<std::int8_t>> exceptions_;  ///< by component: a row, or empty
    std::int64_t step_ = 0;                             ///< actions so far
    std::vector<std::int64_t>
        confirmed_;  ///< by physical variable: the step when it was known last; empty without `:decay`
    std::vector<std::int32_t> before_;
    std::vector<std::int32_t> news_;
};

}  // namespace praxis::belief
