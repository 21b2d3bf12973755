// Finding out first, acting then: everything that can be read is read, the nearest first, whether it matters
// or not; only then is there a plan for the goal.
//
// What chapter 8 of Zhao's thesis (2025) argues against; a measure of what it saves to gather only
// information that the goal needs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "belief/policies/policy.hpp"

namespace praxis::belief {

class SenseFirstPolicy : public Policy {
  public:
    explicit SenseFirstPolicy(const PolicyContext& context);

    Decision next(Belief& belief, const Budget& budget) override;
    std::span<const double> plan_seconds() const override { return plan_seconds_; }

  private:
    /// A reading that may tell about a variable.
    struct Target {
        std::int32_t variable;  ///< of the physical task
        Fact outcome;
        OperatorId reading;  ///< of the compiled task
    };

    /// The next action of the way to a reading; nothing if it does not go on, or is at its end.
    std::optional<std::uint32_t> step(const Belief& belief);
    /// Finds a way to the nearest reading of something unknown. False if there is none.
    bool choose_target(Belief& belief, const Budget& budget);
    bool open(const Belief& belief, const Target& target) const;

    std::shared_ptr<const KnowledgePlanner> planner_;
    AgentOptions options_;
    PreparedTask prepared_;
    std::vector<Target> targets_;
    std::vector<std::uint32_t> attempts_;  ///< by physical variable: how often it was the nearest
    std::vector<OperatorId> steps_;        ///< the way to the reading of `target_`
    std::size_t next_ = 0;
    Target target_{};
    bool sensing_ = true;
    std::vector<double> plan_seconds_;
};

}  // namespace praxis::belief
