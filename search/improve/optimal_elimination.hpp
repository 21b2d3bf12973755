// The cheapest subsequence of a plan that is a plan; see action_elimination.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "search/improve/action_elimination.hpp"
#include "search/improve/plan_execution.hpp"
#include "search/state/state_registry.hpp"

namespace praxis {

class OptimalElimination {
  public:
    /// Refers to its arguments.
    OptimalElimination(const PreparedTask::Parts& parts, const Query& query, std::span<const OperatorId> plan,
                       const Budget& budget, const EliminationLimits& limits);

    /// The best subsequence that is a plan and better than `bound`; nothing if there is none, or if the
    /// limits do not suffice.
    std::optional<std::vector<OperatorId>> run(PlanCost bound);
    /// What `run` said is proved.
    bool finished() const { return finished_; }

  private:
    /// A subsequence: the one of `parent`, then the step at `step`.
    struct Way {
        std::uint32_t parent;
        std::uint32_t step;
        PlanCost cost;
    };
    /// A state after the steps so far, and a cheapest way to it.
    struct Entry {
        StateId state;
        std::uint32_t way;
    };

    bool spent();
    bool find_necessary();
    bool reachable_without(std::size_t left_out);
    void find_last_achievers();

    bool pass_step(std::size_t step, PlanCost bound);
    bool take(std::size_t step, Entry entry);
    void keep(Entry entry, std::uint32_t round);
    bool hopeless(StateId state, std::size_t next_step) const;
    std::vector<OperatorId> steps_of(std::uint32_t way) const;

    const PreparedTask::Parts& parts_;
    const Query& query_;
    std::span<const OperatorId> plan_;
    const Budget& budget_;
    EliminationLimits limits_;
    PlanExecution execution_;
    StateRegistry registry_;
    bool finished_ = false;
    std::size_t steps_ = 0;
    std::size_t unlooked_ = 0;

    std::vector<bool> necessary_;          // by step
    std::vector<bool> derived_condition_;  // by step: its precondition has derived variables
    std::vector<PlanCost> rest_;           // by step: of the necessary steps from there on; one more
    std::vector<std::uint32_t> reached_;   // by fact: marks of reachable_without
    std::uint32_t mark_ = 0;
    struct GoalFact {
        Fact fact;
        std::size_t last;  // the step after the last that may add it; 0: none does
    };
    std::vector<GoalFact> goal_;  // facts that are not derived

    std::vector<Way> ways_;
    std::vector<Entry> current_;
    std::vector<Entry> next_;
    std::vector<std::int32_t> values_;
};

}  // namespace praxis
