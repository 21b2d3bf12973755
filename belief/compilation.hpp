// K(P): planning about knowledge as classical planning (Bonet and Geffner, IJCAI 2011), over finite-domain
// variables.
//
// An uncertain variable becomes one with three values: known to be 0, known to be 1, not known. "L is known"
// is such a fact or, where clauses of the initial description can tell, a derived variable: L is known if all
// other literals of a clause are known to be false; so deduction is no step of a plan. "L is possible" is
// that its opposite is not known. A conditional effect C -> L makes L known where C is (support), and its
// opposite unknown where C is possible (cancellation). An operator with readings becomes two for each of
// them, one an outcome, which make known what was not: the planner chooses the outcome, and the loop sees
// whether it was right. Several readings of one operator are steps of their own that must follow it at once.
// Sensors become cheap operators of that kind.
//
// Components of variables on which conditional effects depend are planned for by cases: the task has a few
// *slots* for cases, each with its own copy of the variables and a mark that it is still possible; something
// is known if it holds in every possible slot, and a reading makes those impossible that would have read
// otherwise.
//
// The translation is linear, sound for what it calls known, and complete for plans that need no reasoning by
// cases beyond that. With more cases than slots, a plan may turn out to be wrong for a case that had none;
// the loop sees it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/components.hpp"

namespace praxis::belief {

/// A clause or group of the first state in which actions can change something: once they may have, nothing is
/// deduced from it any more, and the compiled variable is 1.
struct CompiledClause {
    std::int32_t variable;
    std::vector<std::int32_t> about;  ///< physical variables
};

/// The slots of a component.
struct CompiledComponent {
    std::vector<std::int32_t> possible;  ///< by slot: the variable that is 1 while the case is possible
    std::vector<std::vector<std::int32_t>> values;  ///< by slot and column: the copy of the variable
};

/// What an operator of the compiled task stands for.
struct CompiledOperator {
    static constexpr std::uint32_t kNone = 0xffffffff;
    std::uint32_t action = kNone;  ///< operator of the physical task
    std::uint32_t sensor = kNone;  ///< or a sensor
    /// Or one of several readings of an action, possible right after it only.
    std::uint32_t read_after = kNone;
    bool reads = false;  ///< the outcome of a reading is assumed:
    Fact outcome;        ///< this fact of the physical task is found to hold
};

struct CompilationOptions {
    std::size_t most_cases = 20'000;  ///< components with more cases are not tracked
    std::size_t slots = 16;           ///< cases of a component that are planned for at once
    /// Also readings that tell nothing that any condition asks for. The variables are the same without.
    bool all_readings = false;
    /// What an assumed outcome costs besides, in actions for each factor e by which it is unlikely: weight *
    /// -log p. With 0 plans hope for the best. Counts for searches that look at costs. p: of "one of n", 1 /
    /// n; of a tracked component, the share of its first cases; else a half.
    double risk = 0;
};

class Compilation {
  public:
    explicit Compilation(std::shared_ptr<const BeliefTask> belief, const CompilationOptions& options = {});
    const CompilationOptions& options() const { return options_; }

    const BeliefTask& belief() const { return *belief_; }
    const std::shared_ptr<const BeliefTask>& shared_belief() const { return belief_; }
    const std::shared_ptr<const FiniteDomainTask>& task() const { return task_; }
    const CompiledOperator& origin(OperatorId id) const { return origins_[id.index()]; }

    /// The compiled fact that says that a physical one is known to hold. Not of tracked variables.
    Fact known(Fact fact) const { return known_[fact_number(fact)]; }
    /// The compiled variable of a physical one; the value 2 of an uncertain one is "not known". -1 if
    /// derived.
    std::int32_t variable(std::int32_t physical) const {
        return variables_[static_cast<std::size_t>(physical)];
    }
    static constexpr std::int32_t kNotKnown = 2;
    const std::vector<CompiledClause>& clauses() const { return clauses_; }

    const Components& components() const { return components_; }
    /// As `components().tracked`.
    const std::vector<CompiledComponent>& slots() const { return slots_; }
    /// Variables of tracked components have no single compiled variable.
    bool tracked(std::int32_t physical) const {
        return components_.component_of[static_cast<std::size_t>(physical)] != Components::kNone;
    }

    /// What an action does to knowledge, before its readings: effects as in a FiniteDomainTask, over its
    /// `conditions`.
    /// The action changes more than what is known by its readings.
    bool acts(std::uint32_t action) const { return acting_[action]; }
    /// The compiled variable that tells which action has just been executed, as far as its readings are steps
    /// of their own; 0: none of these. -1 if there is none.
    std::int32_t moment() const { return moment_; }
    std::span<const GroundEffect> effects(std::uint32_t action) const { return action_effects_[action]; }

  private:
    friend class Compiler;
    std::size_t fact_number(Fact fact) const { return belief_->physical->fact_number(fact); }

    std::shared_ptr<const BeliefTask> belief_;
    CompilationOptions options_;
    std::shared_ptr<const FiniteDomainTask> task_;
    std::vector<Fact> known_;              ///< by physical fact
    std::vector<std::int32_t> variables_;  ///< by physical variable
    std::vector<CompiledClause> clauses_;
    Components components_;
    std::vector<CompiledComponent> slots_;
    std::vector<CompiledOperator> origins_;
    PackedLists<GroundEffect> action_effects_;
    std::vector<bool> acting_;  ///< by action
    std::int32_t moment_ = -1;
};

}  // namespace praxis::belief
