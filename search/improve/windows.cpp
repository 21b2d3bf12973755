#include "search/improve/windows.hpp"

#include <algorithm>
#include <optional>

#include "search/improve/plan_execution.hpp"
#include "search/improve/window_search.hpp"

namespace praxis {

namespace {

constexpr std::size_t kShortest = 5;
constexpr std::size_t kLongest = 64;
constexpr std::int32_t kAny = -1;

class Windows {
  public:
    Windows(const PreparedTask::Parts& parts, const Query& query, std::vector<OperatorId> plan,
            const Budget& budget, std::size_t max_states)
        : parts_(parts),
          query_(query),
          budget_(budget),
          max_states_(max_states),
          execution_(parts, query),
          plan_(std::move(plan)) {}

    std::vector<OperatorId> run() {
        bool whole = false;
        for (std::size_t length = kShortest;
             !whole && length <= kLongest && budget_.exhausted() == Stop::none; length *= 2) {
            whole = length >= plan_.size();
            slide(length);
        }
        return std::move(plan_);
    }

  private:
    void slide(std::size_t length) {
        for (std::size_t begin = 0; begin < plan_.size(); begin += (length + 1) / 2) {
            if (budget_.exhausted() != Stop::none) return;
            const std::size_t end = std::min(begin + length, plan_.size());
            replace(begin, end);
            if (end >= plan_.size()) return;
        }
    }

    void replace(std::size_t begin, std::size_t end) {
        const auto first = plan_.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = plan_.begin() + static_cast<std::ptrdiff_t>(end);
        std::vector<std::int32_t> values = execution_.initial();
        for (std::size_t i = 0; i < begin; ++i) execution_.apply(plan_[i], values);
        const std::vector<Fact> goal = window_goal(begin, end, values);
        const PlanCost bound = cost_of(*parts_.task, std::span(first, last));
        WindowSearch search(parts_, {std::move(values), goal}, budget_, max_states_);
        if (const auto better = search.run(bound)) {
            plan_.insert(plan_.erase(first, last), better->begin(), better->end());
        }
    }

    // What the steps from `end` on and the goal need; `values` are those before step `begin`.
    std::vector<Fact> window_goal(std::size_t begin, std::size_t end, std::vector<std::int32_t> values) {
        const FiniteDomainTask& task = *parts_.task;
        const bool simple = !task.has_axioms() &&
                            std::none_of(plan_.begin() + static_cast<std::ptrdiff_t>(end), plan_.end(),
                                         [&](OperatorId op) { return parts_.transitions.conditional(op); });
        if (simple) {
            values.assign(task.variable_count(), kAny);
            const auto need = [&](std::span<const Fact> facts) {
                for (const Fact& fact : facts) values[static_cast<std::size_t>(fact.variable)] = fact.value;
            };
            need(query_.goal);
            for (std::size_t i = plan_.size(); i-- > end;) {
                for (const GroundEffect& effect : task.effects[plan_[i].index()]) {
                    values[static_cast<std::size_t>(effect.fact.variable)] = kAny;
                }
                need(task.preconditions[plan_[i].index()]);
            }
        } else {
            for (std::size_t i = begin; i < end; ++i) execution_.apply(plan_[i], values);
        }
        std::vector<Fact> goal;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto variable = static_cast<std::int32_t>(i);
            if (values[i] != kAny && !task.derived(variable)) goal.push_back({variable, values[i]});
        }
        return goal;
    }

    const PreparedTask::Parts& parts_;
    const Query& query_;
    const Budget& budget_;
    std::size_t max_states_;
    PlanExecution execution_;
    std::vector<OperatorId> plan_;
};

}  // namespace

std::vector<OperatorId> improve_windows(const PreparedTask& prepared, const Query& query,
                                        std::vector<OperatorId> plan, const Budget& budget,
                                        std::size_t max_states) {
    return Windows(prepared.parts(), query, std::move(plan), budget, max_states).run();
}

}  // namespace praxis
