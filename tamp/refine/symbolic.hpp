// The symbolic side of refinement: one ground task, and searches on it under what has been learned so far.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "search/atom_index.hpp"
#include "search/engines/search.hpp"
#include "search/plan.hpp"
#include "search/plan_names.hpp"
#include "search/task/restrict.hpp"
#include "tamp/refine/optimistic.hpp"
#include "tamp/refine/support.hpp"

namespace praxis::tamp {

/// A plan of the symbolic task.
struct SymbolicPlan {
    std::vector<OperatorId> operators;
    std::vector<PlanStep> steps;
};

class SymbolicTask {
  public:
    /// Grounds. If the budget runs out, `grounded()` is false. Throws UnsupportedError as `ground` does.
    SymbolicTask(OptimisticTask optimistic, const std::vector<bool>& certified, const Budget& budget);

    bool grounded() const { return ground_ != nullptr; }
    const OptimisticTask& optimistic() const { return optimistic_; }
    const LiftedTask& lifted() const { return *optimistic_.task; }
    const FiniteDomainTask& ground() const { return *ground_; }
    const SupportRules& rules() const { return rules_; }

    /// By object: a placeholder that states may mention, or that such a one is made from. It stands for one
    /// value in a whole plan; another placeholder may stand for a different value in every action.
    const std::vector<bool>& shared() const { return shared_; }
    /// The fact that says that an atom holds; nothing where it always does. False in `known` if there is no
    /// such fact though it may be false.
    std::optional<Fact> fact(const GroundAtom& atom, bool& known) const;

    struct Found {
        Status status = Status::failed;
        std::optional<SymbolicPlan> plan;
        std::uint64_t evaluated = 0;
    };
    Found plan(std::span<const Nogood> nogoods, const Configuration& configuration,
               const Budget& budget) const;

  private:
    void find_shared();

    OptimisticTask optimistic_;
    SupportRules rules_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    std::optional<AtomIndex> atoms_;
    std::optional<PlanNames> names_;
    std::vector<bool> shared_;
};

}  // namespace praxis::tamp
