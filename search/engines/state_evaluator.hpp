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

    /// Estimates a complete state. False: a safe heuristic says that no plan starts here, and some estimates
    /// are not made.
    bool evaluate(std::span<const std::int32_t> values);
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
    void evaluate_preferred(std::span<const std::int32_t> values);

    /// How many estimates `remember` writes into a node.
    std::size_t remembered() const { return remembered_.size(); }
    void remember(const NodeLayout& layout, std::uint32_t* node) const;
    /// The estimates of a state evaluated before, from its node and, where that is cheap, from its values.
    void restore(const NodeLayout& layout, const std::uint32_t* node, std::span<const std::int32_t> values);
    /// `restore` looks at the values.
    bool restores_from_values() const { return !cheap_.empty(); }

  private:
    std::vector<Heuristic> heuristics_;
    std::vector<std::size_t> in_open_list_;
    std::vector<std::size_t> preferred_from_;
    std::vector<std::size_t> remembered_;
    std::vector<std::size_t> cheap_;
    std::vector<bool> safe_;
    std::vector<Estimate> estimates_;
    std::vector<Estimate> best_;
    std::vector<OperatorId> preferred_;
    std::vector<bool> seen_;
};

}  // namespace praxis
