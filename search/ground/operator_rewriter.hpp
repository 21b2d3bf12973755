// Makes the operators of a propositional task anew, fewer or smaller ones.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "search/ground/proposition_task.hpp"

namespace praxis::grounding {

/// Call `keep` for the operators that stay, in increasing order, then `finish`. What an operator keeps of its
/// schema, row and cost moves along; the old lists can be read until `finish`.
class OperatorRewriter {
  public:
    explicit OperatorRewriter(PropositionTask& task) : task_(task) {
        preconditions_.reserve(task.operator_count(), task.preconditions.total());
        effects_.reserve(task.operator_count(), task.effects.total());
        conditions_.close();
    }

    /// The number of a new effect condition; 0 for the empty one.
    std::uint32_t condition(std::span<const Literal> literals) {
        if (literals.empty()) return 0;
        conditions_.append(literals);
        return static_cast<std::uint32_t>(conditions_.size() - 1);
    }

    void keep(std::size_t o, std::span<const Literal> precondition,
              std::span<const PropositionEffect> effects) {
        preconditions_.append(precondition);
        effects_.append(effects);
        task_.schemas[kept_] = task_.schemas[o];
        task_.rows[kept_] = task_.rows[o];
        if (!task_.costs.empty()) task_.costs[kept_] = task_.costs[o];
        ++kept_;
    }

    void finish() {
        task_.schemas.resize(kept_);
        task_.rows.resize(kept_);
        if (!task_.costs.empty()) task_.costs.resize(kept_);
        task_.preconditions = std::move(preconditions_);
        task_.effects = std::move(effects_);
        task_.conditions = std::move(conditions_);
    }

  private:
    PropositionTask& task_;
    PackedLists<Literal> preconditions_;
    PackedLists<PropositionEffect> effects_;
    PackedLists<Literal> conditions_;
    std::size_t kept_ = 0;
};

}  // namespace praxis::grounding
