// A conditional plan: what to do, whatever is read.
//
// A directed graph without cycles. Each node but the goal has an action of the physical task and, for each
// combination of answers that may come after it, an edge to the node from which to go on. Nodes are shared:
// where two histories are followed by the same plan, they lead to the same node. Node 0 is the first; a node
// whose action is `Environment::kStart` does nothing and only takes in what is read before the first action.
//
// Immutable once made.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "belief/environment.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis::belief {

class ConditionalPlan {
  public:
    /// What is answered about a variable of the physical task: that it has the value, or nothing at all.
    struct Report {
        static constexpr std::int32_t kSilent = -1;
        std::int32_t variable = 0;
        std::int32_t value = kSilent;
        friend auto operator<=>(const Report&, const Report&) = default;
    };
    struct Edge {
        std::uint32_t target = 0;
        std::uint32_t reports = 0;  ///< number of its list of reports
    };
    /// Instead of an action: the goal is known to hold.
    static constexpr std::uint32_t kGoal = 0xfffffffe;

    std::size_t size() const { return actions_.size(); }
    std::uint32_t action(std::uint32_t node) const { return actions_[node]; }
    bool goal(std::uint32_t node) const { return actions_[node] == kGoal; }
    std::span<const Edge> edges(std::uint32_t node) const { return edges_[node]; }
    /// In which the edge differs from the others of its node; sorted.
    std::span<const Report> reports(const Edge& edge) const { return reports_[edge.reports]; }

    /// Where to go on after what is answered: the facts found to hold. Nothing if the plan has no such edge.
    std::optional<std::uint32_t> next(std::uint32_t node, std::span<const Fact> answers) const;

    /// Nodes with an action to execute.
    std::size_t action_nodes() const;
    std::size_t edge_count() const { return edges_.total(); }
    /// Most actions from the first node to the goal.
    std::size_t depth() const;

  private:
    friend class PlanDraft;
    std::vector<std::uint32_t> actions_;  // by node; edges lead to nodes with greater numbers
    PackedLists<Edge> edges_;             // by node
    PackedLists<Report> reports_;
};

/// A conditional plan in the making. Nodes are added after those they lead to, so that no cycle can arise,
/// and equal ones are added once.
class PlanDraft {
  public:
    struct Edge {
        std::vector<Fact> observation;  ///< all that is answered: sorted facts
        std::uint32_t target;
    };

    PlanDraft();
    /// The only node without an action.
    std::uint32_t goal() const { return 0; }
    /// Edges are told apart by what their observations differ in. A choice without a difference (all edges
    /// lead to one node) is none. A node as which there is one already is that one.
    std::uint32_t add(std::uint32_t action, const std::vector<Edge>& edges);
    std::size_t size() const { return nodes_.size(); }

    std::uint32_t action(std::uint32_t node) const { return nodes_[node].action; }
    /// As ConditionalPlan::next.
    std::optional<std::uint32_t> next(std::uint32_t node, std::span<const Fact> answers) const;

    /// The part that can be reached from `first`.
    ConditionalPlan finish(std::uint32_t first) const;

  private:
    struct Choice {
        std::vector<ConditionalPlan::Report> reports;
        std::uint32_t target;
        friend auto operator<=>(const Choice&, const Choice&) = default;
    };
    struct Node {
        std::uint32_t action;
        std::vector<Choice> choices;
        friend auto operator<=>(const Node&, const Node&) = default;
    };
    struct Hash {
        std::size_t operator()(const Node& node) const;
    };

    std::vector<Node> nodes_;
    std::unordered_map<Node, std::uint32_t, Hash> index_;
};

}  // namespace praxis::belief
