#include "belief/offline/working_nodes.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {

std::int64_t WorkingNodes::cost(std::uint32_t node, StateIndex state) {
    const FiniteDomainTask& physical = *table_->task().physical;
    std::vector<std::pair<std::uint64_t, std::int32_t>> path;  // what was asked, and the action's cost
    std::int64_t result = kFails;
    for (;;) {
        if (draft_->action(node) == ConditionalPlan::kGoal) {
            if (table_->goal(state)) result = 0;
            break;
        }
        const std::uint64_t question = (std::uint64_t{node} << 32) | state;
        if (const auto known = costs_.find(question); known != costs_.end()) {
            result = known->second;
            break;
        }
        const std::uint32_t action = draft_->action(node);
        path.emplace_back(question, physical.costs[action]);
        if (!table_->applicable(state, action)) break;
        state = table_->successor(state, action);
        const std::optional<std::uint32_t> next = draft_->next(node, table_->observation(state, action));
        if (!next) break;
        node = *next;
    }
    for (; !path.empty(); path.pop_back()) {
        if (result != kFails) result += path.back().second;
        costs_[path.back().first] = result;
    }
    return result;
}

std::optional<std::uint32_t> WorkingNodes::cheapest(std::span<const std::uint32_t> nodes,
                                                    std::span<const StateIndex> states) {
    std::optional<std::uint32_t> best;
    std::int64_t least = 0;
    const std::size_t first = nodes.size() > kCandidates ? nodes.size() - kCandidates : 0;
    for (std::uint32_t node : nodes.subspan(first)) {
        std::int64_t total = 0;
        const bool works = std::all_of(states.begin(), states.end(), [&](StateIndex state) {
            const std::int64_t one = cost(node, state);
            total += one;
            return one != kFails && (!best || total < least);
        });
        if (!works) continue;
        best = node;
        least = total;
    }
    return best;
}

}  // namespace praxis::belief
