// Plans from what is known now: the compiled task is prepared once and searched from each belief anew.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "belief/belief.hpp"
#include "search/engines/search.hpp"

namespace praxis::belief {

/// A plan whose readings have the outcomes that suit it.
struct KnowledgePlan {
    Status status = Status::failed;
    std::vector<OperatorId> steps;  ///< of the compiled task
    double seconds = 0;             ///< processor time of this thread
};

/// For one thread at a time.
class KnowledgePlanner {
  public:
    explicit KnowledgePlanner(std::shared_ptr<const Compilation> compilation, const Budget& budget = {});

    const Compilation& compilation() const { return *compilation_; }
    const std::shared_ptr<const Compilation>& shared_compilation() const { return compilation_; }

    KnowledgePlan plan(const Belief& belief, const Configuration& configuration, const Budget& budget) const;

    /// The plan's steps from `next` on still lead to the goal, given what is known now.
    bool still_good(const Belief& belief, const std::vector<OperatorId>& steps, std::size_t next) const;
    /// The step tells nothing new and does nothing else.
    bool superfluous(const Belief& belief, OperatorId step) const;

  private:
    bool possible_in_slots(const std::vector<std::int32_t>& values, Fact fact) const;
    bool some_case_left(const std::vector<std::int32_t>& values) const;
    bool apply(std::vector<std::int32_t>& values, OperatorId step) const;

    std::shared_ptr<const Compilation> compilation_;
    PreparedTask prepared_;
    AxiomEvaluator axioms_;
    mutable AxiomEvaluator::Scratch scratch_;
    mutable std::vector<std::int32_t> values_, before_;
};

}  // namespace praxis::belief
