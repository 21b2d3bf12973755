// What a goal costs at least, from any node: the sum of what its facts cost in projections.
//
// Each skill's cost is counted for one fact only, so that the sum is a lower bound (Felner et al. 2004,
// "additive pattern databases"): for the first fact whose variable the skill changes, else for the first of
// all. Facts of derived variables and of those with too
// many values count nothing.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "practice/planning/state_projection.hpp"

namespace praxis::practice {

/// The projections of a graph, made when they are first asked for, and anew when the graph has grown.
class Projections {
  public:
    explicit Projections(const StateGraph& graph) : graph_(&graph) {}
    const StateProjection& onto(std::int32_t variable);

  private:
    const StateGraph* graph_;
    std::vector<std::unique_ptr<const StateProjection>> projections_;  // by variable
};

class GoalBound {
  public:
    /// Nothing is known: 0 everywhere.
    GoalBound() = default;
    /// `costs` by skill. The projections must not change while the bound is used.
    GoalBound(const FiniteDomainTask& task, Projections& projections, std::span<const Fact> goal,
              std::span<const Cost> costs);

    /// kNoPlan where the goal cannot be reached.
    Cost operator()(NodeIndex node) const {
        Cost sum = 0;
        for (const Part& part : parts_) {
            const Cost distance = part.distances[part.projection->state(node)];
            if (distance == kNoPlan) return kNoPlan;
            sum += distance;
        }
        return sum;
    }

  private:
    struct Part {
        const StateProjection* projection;
        std::vector<Cost> distances;
    };
    std::vector<Part> parts_;
};

}  // namespace praxis::practice
