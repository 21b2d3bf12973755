// The landmark-cut heuristic (Helmert and Domshlak 2009): disjunctive action landmarks from cuts, each found
// with the costs that earlier ones left over.
//
// Every rule has a *supporter*: the precondition with the highest hmax cost. The *goal zone* is what reaches
// the goal from supporter to effect without cost. The cut is the operators with a rule that enters the zone
// from a proposition before the zone, one that can be reached without passing through it. Its cheapest
// operator's cost is added to the estimate and taken off all of them; then hmax values are repaired where
// they fell.
//
// Cuts are found backwards from the goal zone. A supporter cheaper than the goal lies before the zone,
// because all of the zone is at least as expensive as the goal; the rare others are traced back. So a round
// costs little more than the zone.
//
// All rules of one operator share its cost (Keyder, Hoffmann and Haslum 2012), so that conditional effects
// keep the estimate admissible. As that can cost quality, the estimate is never lower than hmax.
#pragma once

#include <vector>

#include "search/evaluators/cost_queue.hpp"
#include "search/evaluators/evaluator.hpp"
#include "search/evaluators/missing_preconditions.hpp"
#include "search/evaluators/relaxed_task.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis {

/// Safe and admissible for every task, conditional effects and axioms included; not consistent.
class LMCutEvaluator final : public Evaluator {
  public:
    LMCutEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);

    Estimate evaluate(StateView state) override;
    bool safe() const override { return true; }
    bool admissible() const override { return true; }
    bool consistent() const override { return false; }

  private:
    struct Supporter {
        std::uint32_t proposition;
        std::int32_t cost;
    };

    void explore();
    void repair();
    void fire(std::uint32_t rule);
    void reach(std::uint32_t proposition, std::int32_t cost);
    Supporter most_expensive(std::uint32_t rule) const;

    void mark_goal_zone();
    void find_cut();
    bool before_zone(Supporter supporter);
    bool enters_zone(std::uint32_t rule) const;
    std::int32_t reduce_cut();

    bool in_zone(std::uint32_t proposition) const { return zone_marks_[proposition] == round_; }
    bool reached(std::uint32_t rule) const { return counters_[rule] == 0; }
    std::int32_t cost_of(std::uint32_t rule) const { return costs_[task_.operator_of[rule]]; }
    void next_round();

    RelaxedTask task_;
    PackedLists<std::uint32_t> achievers_;       ///< by proposition: rules
    PackedLists<std::uint32_t> operator_rules_;  ///< by operator

    MissingPreconditions missing_;
    std::vector<std::uint8_t> counters_;
    std::vector<Supporter> supporters_;  ///< by rule that is reached
    std::vector<std::int32_t> unreached_;
    std::vector<std::int32_t> reached_cost_;  ///< by proposition: hmax
    std::vector<std::int32_t> costs_;         ///< by operator: what is left
    CostQueue queue_;

    std::uint32_t round_ = 0;                  ///< number of the cut; marks are equal to it
    std::vector<std::uint32_t> zone_marks_;    ///< by proposition: in the goal zone
    std::vector<std::uint32_t> before_marks_;  ///< by proposition: known to lie before the zone
    std::vector<std::uint32_t> behind_marks_;  ///< by proposition: known not to
    std::vector<std::uint32_t> trace_marks_;   ///< by proposition: seen by trace number `trace_`
    std::uint32_t trace_ = 0;
    std::vector<std::uint32_t> cut_marks_;  ///< by operator
    std::vector<std::uint32_t> zone_;
    std::vector<std::uint32_t> traced_;
    std::vector<std::uint32_t> cut_;  ///< operators
};

}  // namespace praxis
