#include "belief/offline/state_graph.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>

#include "search/state/successor_generator.hpp"

namespace praxis::belief {

std::optional<StateGraph> StateGraph::explore(StateTable& table, std::size_t most, const Budget& budget) {
    const FiniteDomainTask& task = *table.task().physical;
    StateGraph graph;
    const SuccessorGenerator generator(task);
    std::map<std::vector<Fact>, std::uint32_t> numbers;
    std::vector<OperatorId> applicable;
    for (StateIndex state = 0; state < table.size(); ++state) {
        if (table.size() > most || (state % 64 == 0 && budget.exhausted() != Stop::none)) return std::nullopt;
        generator.applicable(table.values(state), applicable);
        std::sort(applicable.begin(), applicable.end());
        for (OperatorId id : applicable) {
            const auto action = static_cast<std::uint32_t>(id.index());
            const StateIndex target = table.successor(state, action);
            const auto place = numbers.emplace(table.observation(target, action),
                                               static_cast<std::uint32_t>(graph.observations_.size()));
            if (place.second) graph.observations_.push_back(place.first->first);
            graph.steps_.add({action, target, place.first->second});
        }
        graph.steps_.close();
        graph.goals_.push_back(table.goal(state));
    }
    graph.compute_distances(task);
    return graph;
}

void StateGraph::compute_distances(const FiniteDomainTask& task) {
    struct Back {
        StateIndex source;
        std::int32_t cost;
    };
    std::vector<std::uint32_t> begin(size() + 1, 0);
    for (const Step& step : steps_.items()) ++begin[step.target + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Back> back(steps_.total());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (StateIndex state = 0; state < size(); ++state)
        for (const Step& step : steps(state)) back[next[step.target]++] = {state, task.costs[step.action]};
    distances_.assign(size(), kUnreachable);
    using Item = std::pair<std::int64_t, StateIndex>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (StateIndex state = 0; state < size(); ++state)
        if (goals_[state]) queue.emplace(distances_[state] = 0, state);
    while (!queue.empty()) {
        const auto [distance, state] = queue.top();
        queue.pop();
        if (distance > distances_[state]) continue;
        for (std::uint32_t i = begin[state]; i < begin[state + 1]; ++i) {
            const std::int64_t longer = distance + back[i].cost;
            if (longer >= distances_[back[i].source]) continue;
            distances_[back[i].source] = longer;
            queue.emplace(longer, back[i].source);
        }
    }
}

}  // namespace praxis::belief
