// The landmark heuristic of LAMA: the cost to reach the landmarks that are still to come.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/landmarks/landmark_graph.hpp"
#include "search/landmarks/landmark_status.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis {

/// The sum, over all future landmarks, of the cost of the cheapest operator that reaches the landmark (of its
/// first achievers, if it is not past). Never kDeadEnd, and 0 in goal states only.
///
/// Preferred operators reach a landmark that is not past and whose predecessors all are; a disjunctive one
/// only if no operator reaches another. If all landmarks are past, they reach one that is required again.
///
/// Outside of a search a state counts as the first one. Refers to the task.
class LandmarkSumEvaluator final : public Evaluator {
  public:
    LandmarkSumEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                         std::span<const std::int32_t> initial_values, CostType cost_type,
                         const LandmarkOptions& options = {});
    /// `graph` is the task's for this goal and the initial state.
    LandmarkSumEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                         std::shared_ptr<const LandmarkGraph> graph, CostType cost_type);

    Estimate evaluate(StateView state) override;

    bool path_dependent() const override { return true; }
    void start(StateId initial, StateView state) override;
    void follow(StateId parent, OperatorId op, StateId child, StateView state) override;
    void at(StateId state) override { at_ = state; }

    std::span<const OperatorId> preferred() const override { return preferred_; }
    void request_preferred() override { preferred_requested_ = true; }

    std::uint64_t effort() const override { return 100 + 6 * graph_->size() + 5 * looks_; }
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

    const LandmarkGraph& graph() const { return *graph_; }
    const LandmarkStatus& status() const { return status_; }

  private:
    struct Achiever {
        OperatorId op;
        std::uint32_t condition;
    };

    bool goal_reached(StateView state) const { return all_hold(goal_, state.data()); }
    void price(CostType cost_type);
    void find_achievers();
    Estimate sum() const;
    void prefer(StateView state);
    /// Adds the applicable operators that reach a wanted landmark of the kind.
    void prefer(StateView state, LandmarkBits wanted, bool disjunctive);

    const FiniteDomainTask& task_;
    std::vector<Fact> goal_;
    std::shared_ptr<const LandmarkGraph> graph_;
    LandmarkStatus status_;
    std::vector<std::int32_t> first_costs_;  ///< by landmark: its cheapest first achiever's
    std::vector<std::int32_t> costs_;        ///< by landmark: its cheapest achiever's
    bool unit_ = true;                       ///< all these are 1
    PackedLists<Achiever> achievers_;        ///< by landmark
    StateId at_;
    std::vector<LandmarkWord> past_;
    std::vector<LandmarkWord> required_again_;
    std::vector<LandmarkWord> wanted_;
    bool preferred_requested_ = false;
    std::vector<OperatorId> preferred_;
    std::vector<std::uint32_t> stamps_;  ///< by operator: when it was last added to the preferred ones
    std::uint32_t stamp_ = 0;
    std::uint64_t looks_ = 0;  ///< at operators, by the last evaluation
};

}  // namespace praxis
