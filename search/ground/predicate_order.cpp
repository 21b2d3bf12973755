#include "search/ground/predicate_order.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace praxis::grounding {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;

void add_edges(const Formula& formula, std::size_t head, Graph& graph) {
    if (formula.kind == Connective::atom) boost::add_edge(head, formula.predicate.index(), graph);
    for (const Formula& child : formula.children) add_edges(child, head, graph);
}

}  // namespace

std::vector<std::vector<PredicateId>> predicate_order(const LiftedTask& task) {
    Graph graph(task.predicates.size());
    for (const Axiom& axiom : task.axioms) add_edges(axiom.body, axiom.predicate.index(), graph);
    // Tarjan's algorithm numbers a component after all components it can reach, which is the order wanted.
    std::vector<std::size_t> component(task.predicates.size());
    const auto map =
        boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph));
    const std::size_t count = task.predicates.empty() ? 0 : boost::strong_components(graph, map);
    std::vector<std::vector<PredicateId>> result(count);
    for (std::size_t p = 0; p < component.size(); ++p) result[component[p]].emplace_back(p);
    return result;
}

}  // namespace praxis::grounding
