#include "search/improve/improve_plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "search/improve/action_elimination.hpp"
#include "search/improve/neighbourhood.hpp"
#include "search/improve/plan_execution.hpp"
#include "search/improve/windows.hpp"

namespace praxis {

namespace {

constexpr std::size_t kFirstStates = 2'000;
constexpr std::size_t kGrowth = 5;

class Improvement {
  public:
    Improvement(const PreparedTask& prepared, const Query& query, std::vector<OperatorId> plan,
                const Budget& budget, const ImproveOptions& options)
        : prepared_(prepared),
          query_(query),
          budget_(budget),
          options_(options),
          plan_(std::move(plan)),
          cost_(cost_of(prepared.task(), plan_)) {}

    std::vector<OperatorId> run() {
        eliminate();
        for (bool improved = true; improved && !done();) {
            const PlanCost before = cost_;
            search_neighbourhoods();
            if (!done() && options_.window_states > 0) {
                take(improve_windows(prepared_, query_, plan_, budget_, options_.window_states));
            }
            improved = cost_ < before;
        }
        return std::move(plan_);
    }

  private:
    bool done() const { return optimal_ || budget_.exhausted() != Stop::none; }

    // Replaces the plan if the other is better.
    bool take(std::vector<OperatorId> plan) {
        const PlanCost cost = cost_of(prepared_.task(), plan);
        if (cost >= cost_) return false;
        plan_ = std::move(plan);
        cost_ = cost;
        return true;
    }

    void eliminate() {
        EliminationLimits limits;
        limits.max_nodes = options_.max_states;
        take(eliminate_actions(prepared_, query_, plan_, budget_, limits).plan);
    }

    // Graphs of growing size; the largest again as long as it helps.
    void search_neighbourhoods() {
        for (std::size_t states = std::min(kFirstStates, options_.max_states);;) {
            Neighbourhood found =
                search_neighbourhood(prepared_, query_, plan_, budget_, {states, options_.max_bytes});
            optimal_ = found.complete;
            const bool improved = take(std::move(found.plan));
            if (done()) return;
            if (improved) eliminate();
            if (!improved && states == options_.max_states) return;
            states = std::min(states * kGrowth, options_.max_states);
        }
    }

    const PreparedTask& prepared_;
    const Query& query_;
    const Budget& budget_;
    const ImproveOptions& options_;
    std::vector<OperatorId> plan_;
    PlanCost cost_;
    bool optimal_ = false;
};

}  // namespace

std::vector<OperatorId> improve_plan(const PreparedTask& prepared, const Query& query,
                                     std::vector<OperatorId> plan, const Budget& budget,
                                     const ImproveOptions& options) {
    if (!PlanExecution(prepared.parts(), query).trace(plan)) {
        throw std::invalid_argument("what is to be improved is not a plan");
    }
    if (prepared.stop() != Stop::none) return plan;
    return Improvement(prepared, query, std::move(plan), budget, options).run();
}

}  // namespace praxis
