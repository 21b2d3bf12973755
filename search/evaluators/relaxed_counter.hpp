// How many facts of a relaxed plan the way to a state has already reached: the counter #r of best-first width
// search (Lipovetzky and Geffner, AAAI 2017).
//
// The relaxed plan is that of the last state on the way where fewer goals were open than ever before on it
// (FF's relaxed plan, so it is computed rarely). Only the first way to a state counts.
#pragma once

#include <optional>
#include <vector>

#include "search/evaluators/ff.hpp"
#include "search/evaluators/goal_count.hpp"
#include "search/state/record_pool.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// A number of facts, 0 where the relaxed plan has just been computed; kDeadEnd if there is none. Meant as
/// partition for novelty, not as goal distance. The task must outlive the evaluator.
class RelaxedCounterEvaluator final : public Evaluator {
  public:
    /// `relaxed` is the task's relaxation for the goal with unit costs.
    RelaxedCounterEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                            std::shared_ptr<const RelaxedTask> relaxed);

    bool path_dependent() const override { return true; }
    void start(StateId initial, StateView state) override;
    void follow(StateId parent, OperatorId op, StateId child, StateView state) override;
    void at(StateId state) override { at_ = state; }
    Estimate evaluate(StateView state) override;
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }
    std::uint64_t effort() const override { return 100 + spent_; }

  private:
    /// The facts of a relaxed plan that did not hold in its state; bit i of a record is about the i-th.
    struct Root {
        Estimate open_goals = 0;
        bool dead_end = false;
        std::vector<std::uint32_t> facts;  ///< in increasing order
    };
    /// At most so many facts of a relaxed plan count.
    static constexpr std::size_t kMaxWords = 16;

    Root make_root(StateView state, Estimate open_goals);
    /// Adds the record of the next state, which is a root.
    void commit(Root root);

    const FiniteDomainTask& task_;
    FFEvaluator ff_;
    GoalCountEvaluator goal_count_;
    std::vector<Root> roots_;
    std::size_t words_ = 0;              ///< of bits, a state
    std::optional<RecordPool> records_;  ///< by state: number of the root, bits
    std::vector<char> is_new_;           ///< by fact; scratch
    StateId at_;
    std::uint64_t pending_ = 0;  ///< effort for relaxed plans since the last evaluation
    std::uint64_t spent_ = 0;    ///< and before it
};

}  // namespace praxis
