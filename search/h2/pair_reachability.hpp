// The fixpoint at the heart of h2 (Haslum & Geffner, "Admissible Heuristics for Optimal Planning", AIPS
// 2000): which pairs of facts may hold together, when a set of steps is applied again and again. Forward and
// backward reachability are two readings of the same operators as steps, see mutex_pairs.hpp.
//
// A step is looked at 64 facts at a time: the rows of the facts it needs, intersected, are the facts that may
// hold beside it; without the variables it sets and with what it adds, they are the facts that may hold after
// it, and all of them become related to what it adds. A step is looked at again only when a row it reads has
// grown.
#pragma once

#include <cstdint>
#include <vector>

#include "search/budget.hpp"
#include "search/h2/pair_matrix.hpp"
#include "search/h2/value_check.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Facts by number. Lists are by step.
struct PairSteps {
    PackedLists<std::uint32_t> needs;    ///< hold before
    PackedLists<std::uint32_t> changes;  ///< variables whose value before is lost
    PackedLists<std::uint32_t> adds;     ///< may hold after
    PackedLists<std::uint32_t> surely;   ///< hold after, if the step is possible; may be left empty
    /// Steps that may happen together with this one (effects of the same operator, each under its own
    /// condition): first and last + 1. The first fact that each of them adds may hold after both.
    struct Range {
        std::uint32_t first = 0, last = 0;
    };
    std::vector<Range> companions;

    std::size_t size() const { return companions.size(); }
};

class PairReachability {
  public:
    /// Keeps references. Only pairs in `allowed` are ever reached; `reached` are those to start with.
    PairReachability(const FiniteDomainTask& task, const ValueCheck& values, const PairSteps& steps,
                     const PairMatrix& allowed, PairMatrix reached);

    /// To the fixpoint. False if the budget ran out before.
    bool run(const Budget& budget);

    /// Pairs reached; only meaningful at the fixpoint.
    PairMatrix& reached() { return reached_; }
    /// At the fixpoint: some state made of reached pairs may allow the step and lead to one.
    bool possible(std::uint32_t step);

  private:
    bool due(std::uint32_t step) const;
    bool look(std::uint32_t step);
    void apply(std::uint32_t step);

    const FiniteDomainTask& task_;
    const ValueCheck& values_;
    const PairSteps& steps_;
    const PairMatrix& allowed_;
    PairMatrix reached_;
    FactBits facts_;                     // that are reached
    std::vector<std::uint64_t> grown_;   // by fact: when its row last grew
    std::vector<std::uint64_t> looked_;  // by step: when it was last looked at
    std::uint64_t facts_grown_ = 1;      // when `facts_` last grew
    std::uint64_t clock_ = 1;
    FactBits before_, after_;  // of the step looked at
};

}  // namespace praxis
