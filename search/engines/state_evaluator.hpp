// The heuristics of a search, each evaluated once a state.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "search/engines/node.hpp"
#include "search/engines/search_plan.hpp"

namespace praxis {

class StateEvaluator {
  public:
    StateEvaluator(std::vector<Heuristic> heuristics, const SearchPlan& plan);

    /// Some heuristic must see every transition.
    bool path_dependent() const { return !path_dependent_.empty(); }
    /// The search starts here; the complete values of the state.
    void start(StateId initial, std::span<const std::int32_t> values);
    /// The search makes a transition; the complete values of `child`.
    void follow(StateId parent, OperatorId op, StateId child, std::span<const std::int32_t> values);

    /// Estimates a complete state reached at cost `g`. False: a safe heuristic says that no plan starts here,
    /// and some estimates are not made.
    bool evaluate(StateId state, std::span<const std::int32_t> values, std::int64_t g);
    /// Of the state last evaluated or restored, by heuristic.
    std::span<const Estimate> estimates() const { return estimates_; }
    /// Some heuristic of the open list has never been as low as in the state last evaluated.
    bool progress();
    /// The lowest estimate of the first heuristic so far.
    std::optional<std::int32_t> best_estimate() const;

    /// Preferred operators of the state last evaluated; those of several heuristics together, without
    /// repetition.
    const std::vector<OperatorId>& preferred();
    bool has_preferred() const { return !preferred_from_.empty(); }
    /// Evaluates only the heuristics that prefer operators.
    void evaluate_preferred(StateId state, std::span<const std::int32_t> values, std::int64_t g);

    /// The effort of all evaluations so far; see Evaluator.
    std::uint64_t effort() const { return effort_; }

    /// How many estimates `remember` writes into a node.
    std::size_t remembered() const { return remembered_.size(); }
    void remember(const NodeLayout& layout, std::uint32_t* node) const;
    /// The estimates of a state evaluated before, from its node and, where that is cheap, from its values.
    void restore(const NodeLayout& layout, const std::uint32_t* node, std::span<const std::int32_t> values);
    /// `restore` looks at the values.
    bool restores_from_values() const { return !cheap_.empty(); }

  private:
    Estimate estimate(std::size_t i, std::span<const std::int32_t> values, std::int64_t g);

    std::vector<Heuristic> heuristics_;
    std::vector<Evaluator*> path_dependent_;
    std::vector<std::int64_t> given_;
    std::vector<std::size_t> in_open_list_;
    std::vector<std::size_t> preferred_from_;
    std::vector<std::size_t> remembered_;
    std::vector<std::size_t> cheap_;
    std::vector<bool> safe_;
    std::vector<Estimate> estimates_;
    std::vector<Estimate> best_;
    std::uint64_t effort_ = 0;
    std::vector<OperatorId> preferred_;
    std::vector<bool> seen_;
};

}  // namespace praxis
