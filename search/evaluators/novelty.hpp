// Novelty of width 1 or 2: the size of the smallest set of facts that the search has not seen together before
// (Lipovetzky and Geffner, AAAI 2017), where states count as seen only by states with the same values of
// other evaluators.
//
// Each partition has a bit for every fact and one for every pair of facts. Only sets with a fact that the
// last operator made true are looked at, since the others were in the state before. The tables of all
// partitions stay below a limit: when it is reached, further partitions share the tables there are, and where
// a single table is too large, pairs share bits. Sharing can only make a state look less novel (approximate
// novelty; Singh, Lipovetzky, Ramirez and Segovia-Aguas, ICAPS 2021).
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct NoveltyOptions {
    int width = 2;        ///< 1 or 2
    bool forget = false;  ///< start anew when a value of the partition is a new best one
    std::size_t memory = std::size_t{1} << 27;  ///< bytes for tables, at most
};

/// 1, 2, ... `width`, or width + 1 if nothing is new. Never kDeadEnd. Depends on all states evaluated before,
/// so each state must be evaluated once, in the order of the search. The task must outlive the evaluator.
class NoveltyEvaluator final : public Evaluator {
  public:
    NoveltyEvaluator(const FiniteDomainTask& task, const NoveltyOptions& options);

    bool path_dependent() const override { return true; }
    void start(StateId initial, StateView state) override;
    void follow(StateId parent, OperatorId op, StateId child, StateView state) override;
    void given(std::span<const std::int64_t> values) override {
        partition_.assign(values.begin(), values.end());
    }
    Estimate evaluate(StateView state) override;
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

  private:
    using Table = std::vector<std::uint64_t>;

    std::size_t pair_bit(std::uint32_t a, std::uint32_t b) const;
    Table& table();
    void forget_on_progress();
    static bool add(Table& table, std::size_t bit);

    const FiniteDomainTask& task_;
    NoveltyOptions options_;
    std::size_t pair_bits_ = 0;  ///< in one table
    std::size_t most_tables_ = 1;
    std::vector<Table> tables_;
    std::map<std::vector<std::int64_t>, std::size_t> numbers_;  ///< by partition: its table
    std::vector<std::int64_t> partition_;
    std::vector<std::int64_t> best_;
    std::vector<std::uint32_t> facts_;   ///< of the state, those of `changed_` first
    std::vector<std::int32_t> changed_;  ///< variables
    std::vector<std::uint32_t> seen_;    ///< by variable: the last evaluation that looked at it
    std::uint32_t stamp_ = 0;
};

}  // namespace praxis
