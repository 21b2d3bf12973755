// What the cheapest plan from one state would cost if one skill were cheaper, for many skills at once.
//
// With D the cost of the cheapest plan now, only nodes on plans cheaper than D matter. They are found once
// for all improvements, by two searches (Dijkstra 1959) that meet:
//
//     before(n)   what leads from the state to n costs at least, if all skills improve together
//     after(n)    what leads from n to the goal costs now; only where before(n) + after(n) < D
//
// The first search leaves out nodes from where a `GoalBound` says that the goal is too far.
//
// For one improvement, the nodes that come nearer to the goal are looked at, the nearest first (after
// Ramalingam and Reps 1996), and of those only the ones with before + (new distance) below the best plan yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "practice/planning/goal_bound.hpp"

namespace praxis::practice {

/// What if a skill cost this?
struct Improvement {
    SkillIndex skill;
    Cost cost;
};

/// Scratch memory for one thread.
class ImprovedPaths {
  public:
    explicit ImprovedPaths(const StateGraph& graph) : graph_(&graph) {}

    /// Begins with a state, its goal, and its cheapest plan now; `costs` by skill. `least`: by skill, the
    /// lowest cost that `cost` will be asked for, at most the present one; `bound` is for those costs. The
    /// spans must outlive the calls of `cost`.
    void begin(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
               std::span<const Cost> least, const GoalBound& bound, std::span<const SkillIndex> plan,
               Cost plan_cost);
    /// The cost of the cheapest plan if one skill improves; no dearer than it is now.
    Cost cost(const Improvement& improvement);

  private:
    /// An edge that an improvement may make part of a cheaper plan.
    struct Chance {
        NodeIndex from, to;
        std::int32_t next;  // of the same skill, in `chances_`; -1: none
    };
    void search_before(std::span<const NodeIndex> goals, std::span<const Cost> least, const GoalBound& bound);
    void search_after(std::span<const Cost> least);

    const StateGraph* graph_;
    NodeIndex from_ = 0;
    std::span<const Cost> costs_;
    std::span<const SkillIndex> plan_;
    Cost plan_cost_ = 0;
    NodeQueue queue_;
    NodeCosts goals_, before_, after_, nearer_;
    std::vector<NodeIndex> goals_met_;
    std::vector<Chance> chances_;
    std::vector<std::int32_t> first_chance_;  // by skill
};

}  // namespace praxis::practice
