#include "search/improve/action_elimination.hpp"

#include "search/improve/optimal_elimination.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

namespace {

constexpr std::size_t kStepsBetweenLooks = 1024;

class GreedyElimination {
  public:
    GreedyElimination(const PreparedTask::Parts& parts, const Query& query, std::vector<OperatorId> plan,
                      const Budget& budget, std::size_t max_steps)
        : execution_(parts, query), budget_(budget), max_steps_(max_steps), plan_(std::move(plan)) {}

    std::vector<OperatorId> run() {
        while (remove_most_expensive()) {
        }
        remove_first_found();
        return std::move(plan_);
    }

  private:
    // Removes the dearest redundant set that some step belongs to as its first; false if there is none, or if
    // the share of the steps for this part is used up.
    bool remove_most_expensive() {
        PlanCost most;
        std::vector<OperatorId> best;
        std::vector<std::int32_t> values = execution_.initial();
        for (std::size_t i = 0; i < plan_.size(); ++i) {
            if (steps_ + plan_.size() > max_steps_ / 2 || spent()) return false;
            if (redundant(i, values) && removed_ > most) {
                most = removed_;
                best = kept_;
            }
            execution_.apply(plan_[i], values);
        }
        if (most == PlanCost{}) return false;
        plan_ = std::move(best);
        return true;
    }

    // One pass from the first step to the last, removing whatever can be.
    void remove_first_found() {
        std::vector<std::int32_t> values = execution_.initial();
        for (std::size_t i = 0; i < plan_.size();) {
            if (steps_ + plan_.size() > max_steps_ || spent()) return;
            if (redundant(i, values)) {
                plan_ = kept_;
            } else {
                execution_.apply(plan_[i++], values);
            }
        }
    }

    // Step i can be left out with what needs it; `before` are the values there. Sets `kept_` and `removed_`.
    bool redundant(std::size_t i, const std::vector<std::int32_t>& before) {
        values_ = before;
        kept_.assign(plan_.begin(), plan_.begin() + static_cast<std::ptrdiff_t>(i));
        removed_ = execution_.cost(plan_[i]);
        for (std::size_t j = i + 1; j < plan_.size(); ++j) {
            if (execution_.applicable(plan_[j], values_)) {
                execution_.apply(plan_[j], values_);
                kept_.push_back(plan_[j]);
            } else {
                removed_ = removed_ + execution_.cost(plan_[j]);
            }
        }
        steps_ += plan_.size() - i;
        unlooked_ += plan_.size() - i;
        return execution_.goal(values_);
    }

    bool spent() {
        if (unlooked_ >= kStepsBetweenLooks) {
            unlooked_ = 0;
            ended_ = budget_.exhausted() != Stop::none;
        }
        return ended_;
    }

    PlanExecution execution_;
    const Budget& budget_;
    std::size_t max_steps_;
    std::size_t steps_ = 0;
    std::size_t unlooked_ = kStepsBetweenLooks;
    bool ended_ = false;  // the budget, when it was last looked at
    std::vector<OperatorId> plan_;
    std::vector<std::int32_t> values_;
    std::vector<OperatorId> kept_;
    PlanCost removed_;
};

}  // namespace

std::vector<OperatorId> eliminate_actions_greedily(const PreparedTask& prepared, const Query& query,
                                                   std::vector<OperatorId> plan, const Budget& budget,
                                                   const EliminationLimits& limits) {
    return GreedyElimination(prepared.parts(), query, std::move(plan), budget, limits.max_steps).run();
}

Elimination eliminate_actions(const PreparedTask& prepared, const Query& query, std::vector<OperatorId> plan,
                              const Budget& budget, const EliminationLimits& limits) {
    const PreparedTask::Parts& parts = prepared.parts();
    Elimination result;
    result.plan = eliminate_actions_greedily(prepared, query, plan, budget, limits);
    OptimalElimination optimal(parts, query, plan, budget, limits);
    if (auto better = optimal.run(cost_of(*parts.task, result.plan))) result.plan = std::move(*better);
    result.optimal = optimal.finished();
    return result;
}

}  // namespace praxis
