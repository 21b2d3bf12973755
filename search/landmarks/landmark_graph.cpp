#include "search/landmarks/landmark_graph.hpp"

#include <algorithm>

#include "search/landmarks/landmark_draft.hpp"
#include "search/state/axiom_evaluator.hpp"

namespace praxis {

std::size_t LandmarkGraph::ordering_count(LandmarkOrdering ordering) const {
    return static_cast<std::size_t>(std::ranges::count(predecessors.items(), ordering, &Neighbour::ordering));
}

LandmarkGraph make_landmark_graph(const FiniteDomainTask& task, std::span<const Fact> goal,
                                  std::span<const std::int32_t> initial_values,
                                  const LandmarkOptions& options) {
    std::vector<std::int32_t> initial(initial_values.begin(), initial_values.end());
    AxiomEvaluator::Scratch scratch;
    AxiomEvaluator(task).complete(initial.data(), scratch);

    LandmarkDraft draft = backchain(task, goal, initial, options);
    if (options.reasonable) add_reasonable_orderings(task, draft);
    const std::vector<std::uint32_t> order = break_cycles(draft);

    LandmarkGraph graph;
    graph.complete = draft.complete;
    std::vector<std::uint32_t> number(draft.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
    std::vector<std::vector<LandmarkGraph::Neighbour>> before(order.size()), after(order.size());
    for (const LandmarkDraft::Ordering& o : draft.orderings) {
        before[number[o.after]].push_back({number[o.before], o.ordering});
        after[number[o.before]].push_back({number[o.after], o.ordering});
    }
    std::vector<std::vector<std::uint32_t>> undone_by(order.size());
    for (const LandmarkDraft::Ordering& o : draft.dropped) {
        undone_by[number[o.after]].push_back(number[o.before]);
    }
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const LandmarkDraft::Node& node = draft.nodes[order[i]];
        graph.facts.append(node.facts);
        graph.first_achievers.append(node.first_achievers);
        graph.goal.push_back(node.goal);
        graph.initial.push_back(graph.holds(i, initial));
        graph.derived.push_back(
            std::ranges::any_of(node.facts, [&](Fact fact) { return task.derived(fact.variable); }));
        std::ranges::sort(before[i], {}, &LandmarkGraph::Neighbour::landmark);
        std::ranges::sort(after[i], {}, &LandmarkGraph::Neighbour::landmark);
        graph.undone_by.append(undone_by[i]);
        graph.predecessors.append(before[i]);
        graph.successors.append(after[i]);
    }
    return graph;
}

}  // namespace praxis
