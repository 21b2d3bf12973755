// What the agent knows: of every physical fact, that it holds, that it does not, or neither.
//
// Knowledge of the present is kept as values of the compiled task (so that a search can start from it at
// once), and knowledge of the first state beside it: a reading of a variable that no action has touched since
// tells about the first state, and by its clauses about other variables. Of components that are tracked, all
// possible cases are kept. After an action that failed it is not known whether it happened (`Hypotheses`).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "belief/cases.hpp"
#include "belief/compilation.hpp"
#include "belief/derived_knowledge.hpp"
#include "belief/hypotheses.hpp"
#include "belief/initial_knowledge.hpp"
#include "belief/percept.hpp"
#include "search/engines/random.hpp"
#include "search/state/axiom_evaluator.hpp"

namespace praxis::belief {

/// What plans suppose of certain variables, of those that failed actions may have changed.
struct Supposition {
    std::vector<Fact> facts;
};
/// "Atom at(desk), NegatedAtom holding(box1)".
std::string to_string(const Supposition& supposed, const FiniteDomainTask& task);

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
    /// The action's precondition is known to hold, or supposed to where it is in doubt.
    bool can(std::uint32_t action) const { return supposes(physical().preconditions[action]); }
    bool goal_known() const { return knows(physical().goal); }
    /// As `knows`, what is in doubt after failures being as plans suppose it.
    bool supposes(std::span<const Fact> facts) const;
    bool supposes(Fact fact) const { return supposed(fact.variable) == fact.value; }
    /// A failed action may have changed the variable.
    bool in_doubt(std::int32_t variable) const { return hypotheses_.about(variable); }
    /// An action may have changed the variable since the start.
    bool touched(std::int32_t variable) const { return touched_[static_cast<std::size_t>(variable)]; }
    /// Tells beliefs apart (up to chance).
    std::uint64_t fingerprint() const;

    /// What is known after an action whose precondition holds, before it is seen what came of it.
    void act(std::uint32_t action);
    /// A reading without error: `fact` holds now. Returns false, and changes nothing, if that contradicts
    /// what is known.
    bool learn(Fact fact);
    /// What is known after an action that failed: it happened as a whole or not at all. Returns what plans
    /// suppose from now on: that it did not, unless it failed because what was supposed is not so. Nothing if
    /// no certain variable is in doubt.
    std::optional<Supposition> fail(std::uint32_t action);
    /// The world has refused the action, which changed nothing: what is supposed is not so. Nothing if
    /// nothing in doubt explains that.
    std::optional<Supposition> refuse(std::uint32_t action);
    /// Supposes something else of what is in doubt. Nothing if nothing is.
    std::optional<Supposition> suppose_otherwise();

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
    std::int32_t supposed(std::int32_t variable) const;
    KnownBeside beside() const;
    /// The variables that an action may change and that are not tracked.
    std::vector<std::int32_t> changeable(std::uint32_t action) const;
    /// By effect, whether what is not tracked of its condition holds: as it may be.
    std::vector<Cases::Way> ways(std::uint32_t action);
    void touch(std::uint32_t action);
    /// Takes over what the hypotheses agree in, and what is supposed.
    void settle();
    Supposition supposition() const;
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
    DerivedKnowledge supposed_derived_;  ///< while something is in doubt
    Hypotheses hypotheses_;
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
