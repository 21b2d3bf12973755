// Policies: other ways to choose the next action than `Agent`'s, over the same Belief and Environment.
//
// They are what a planner of knowledge is measured against: acting at random, and finding out everything
// first. `make_policy` knows them by name; `run_policy` executes one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "belief/agent.hpp"
#include "belief/belief.hpp"
#include "belief/offline/conditional_plan.hpp"

namespace praxis::belief {

/// What a policy wants.
struct Decision {
    enum class Kind : std::uint8_t {
        act,   ///< `action`, an operator of the physical task
        plan,  ///< the loop is to do the rest
        stop,  ///< there is nothing to do; the run is stuck
    };
    Kind kind = Kind::stop;
    std::uint32_t action = Environment::kStart;
};

/// Chooses actions in one run.
class Policy {
  public:
    virtual ~Policy() = default;
    /// The next action. The goal is not known to hold. May choose which cases the belief shows to plans.
    virtual Decision next(Belief& belief, const Budget& budget) = 0;
    /// What has been read after an action, and before the first one.
    virtual void observed(std::span<const Answer>) {}
    /// The last action failed or was refused.
    virtual void failed() {}
    /// Chooses actions that the world may refuse; a refusal costs a step and no more.
    virtual bool tries_anything() const { return false; }
    /// Processor seconds of each search for a plan so far.
    virtual std::span<const double> plan_seconds() const { return {}; }
};

/// What policies are made of.
struct PolicyContext {
    std::shared_ptr<const KnowledgePlanner> planner;
    AgentOptions options = default_agent_options();  ///< searches and limits of the run
    std::uint64_t seed = 0;                          ///< of random choices
    /// For "best": a plan for all readings from the first state, made once for all runs; null if there is
    /// none.
    std::shared_ptr<const ConditionalPlan> prepared = nullptr;
};

struct PolicyKind {
    const char* name;
    const char* what;  ///< one sentence
    std::unique_ptr<Policy> (*make)(const PolicyContext& context);
};

/// All policies.
std::span<const PolicyKind> policy_kinds();

/// The policy of that name. Throws std::invalid_argument with the names that there are.
std::unique_ptr<Policy> make_policy(const std::string& name, const PolicyContext& context);

}  // namespace praxis::belief
