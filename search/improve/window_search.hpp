// A bounded A* search for a cheaper way through one window of a plan; see windows.hpp.
#pragma once

#include <optional>
#include <queue>
#include <vector>

#include "search/evaluators/lmcut.hpp"
#include "search/improve/plan_execution.hpp"
#include "search/state/state_registry.hpp"

namespace praxis {

class WindowSearch {
  public:
    /// `query` is where the window begins, complete, and what must hold at its end. Refers to the others.
    WindowSearch(const PreparedTask::Parts& parts, Query query, const Budget& budget, std::size_t max_states);

    /// A way that costs less than `bound`, a cheapest one; nothing if there is none or the states or the
    /// budget do not suffice.
    std::optional<std::vector<OperatorId>> run(PlanCost bound);

  private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    struct Node {
        PlanCost cost;
        std::uint32_t parent;
        OperatorId op;
        Estimate estimate;
    };
    struct QueueEntry {
        PlanCost least;  // of ways through the state
        std::int64_t estimate;
        PlanCost cost;
        std::uint32_t state;
        friend auto operator<=>(const QueueEntry&, const QueueEntry&) = default;
    };

    void reach(std::uint32_t state, const Node& node, PlanCost bound);
    void expand(std::uint32_t state, PlanCost bound);
    std::vector<OperatorId> steps_to(std::uint32_t state) const;

    const PreparedTask::Parts& parts_;
    Query query_;
    const Budget& budget_;
    std::size_t max_states_;
    PlanExecution execution_;
    LMCutEvaluator evaluator_;
    StateRegistry registry_;
    std::vector<Node> nodes_;  // by state
    std::priority_queue<QueueEntry, std::vector<QueueEntry>, std::greater<>> queue_;
    std::vector<std::int32_t> values_;
    std::vector<std::int32_t> child_values_;
};

}  // namespace praxis
