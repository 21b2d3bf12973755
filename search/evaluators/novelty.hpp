// Novelty of width 1 or 2: the size of the smallest set of facts that the search has not seen together before
// (Lipovetzky and Geffner, AAAI 2017), where states count as seen only by states with the same values of
// other evaluators.
//
// Only sets with a fact that the last operator made true are looked at, since the others were in the state
// before. Small tasks have a table for each partition, with a bit for every fact and every pair of facts;
// when all tables together reach the limit, further partitions share them. Where one table would be large,
// all partitions share one field of bits instead, in which a hash of the partition and a fact says where the
// bits of the pairs with that fact begin: nothing is set up for a new partition, and forgetting is free.
// Sharing can only make a state look less novel (approximate novelty; Singh, Lipovetzky, Ramirez and
// Segovia-Aguas, ICAPS 2021), until so many bits are set that the field is cleared.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct NoveltyOptions {
    int width = 2;        ///< 1 or 2
    bool forget = false;  ///< start anew when a value of the partition is a new best one
    std::size_t memory = std::size_t{1} << 27;  ///< bytes for tables, at most
    /// Bits of a table, at most; where more would be needed, partitions share the field.
    std::size_t largest_table = std::size_t{1} << 20;
    /// Pairs to look at in a state, taken evenly from all; about.
    std::size_t sample = std::numeric_limits<std::size_t>::max();
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
    std::uint64_t effort() const override { return 100 + 2 * task_.variable_count() + 8 * looks_; }
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

  private:
    std::uint64_t row(std::uint64_t fact) const;
    std::size_t single_bit(std::uint32_t fact) const;
    std::size_t pair_bit(std::uint32_t a, std::uint32_t b) const;
    void enter_partition();
    void forget_on_progress();
    bool add(std::size_t bit);
    void clear();

    const FiniteDomainTask& task_;
    NoveltyOptions options_;
    std::size_t table_bits_;  ///< of one partition
    std::size_t most_tables_ = 0;
    bool hashed_;                                               ///< all partitions share the field
    std::vector<std::uint64_t> bits_;                           ///< one table after the other, or the field
    std::size_t set_ = 0;                                       ///< bits of the field
    std::map<std::vector<std::int64_t>, std::size_t> numbers_;  ///< by partition: its table
    std::uint64_t base_ = 0;  ///< where the table of the partition in hand begins, or its hash
    std::uint64_t generation_ = 0;
    std::size_t turn_ = 0;     ///< shifts the sample
    std::uint64_t looks_ = 0;  ///< at pairs, by the last evaluation
    std::vector<std::int64_t> partition_;
    std::vector<std::int64_t> best_;
    std::vector<std::uint32_t> facts_;   ///< of the state, those of `changed_` first
    std::vector<std::int32_t> changed_;  ///< variables
    std::vector<std::uint32_t> seen_;    ///< by variable: the last evaluation that looked at it
    std::uint32_t stamp_ = 0;
};

}  // namespace praxis
