// The loop: plan, execute, observe, update, and plan again when things are not as hoped.
//
// Algorithm 1 of chapter 8 of Zhao's thesis (2025), after the K-replanner (Bonet and Geffner 2011): the plan
// is followed as long as its remaining steps lead to the goal from what is known now; that holds exactly if
// everything that was assumed and still matters came true. A belief that keeps coming back ends the run.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "belief/environment.hpp"
#include "belief/knowledge_planner.hpp"

namespace praxis::belief {

struct AgentOptions {
    /// The search for each plan; where it finds none in `plan_seconds` (of wall time), `second` has
    /// `second_seconds`.
    Configuration first;
    Configuration second;
    double plan_seconds = 2;
    double second_seconds = 10;
    std::size_t most_steps = 100'000;  ///< actions
    std::size_t most_plans = 100'000;
    /// Readings of accuracy below 1 are weighed, and believed from this probability on (see `Evidence`); 0:
    /// every reading is believed at once.
    double accept = 0;
    /// A reading that contradicts what is known is passed over, and does not end the run.
    bool ignore_contradictions = false;
    std::size_t most_returns = 8;  ///< to one belief, when planning, before the run counts as stuck
};

/// Searches that suit most tasks. `axioms`: of the compiled task, whose states cost more the more there are.
AgentOptions default_agent_options(std::size_t axioms = 0);

enum class RunStatus : std::uint8_t {
    reached,     ///< the goal is known to hold
    infeasible,  ///< no plan, whatever the readings may be
    not_found,   ///< the search found no plan, without a proof
    stuck,       ///< one belief came back too often
    step_limit,
    out_of_time,
    out_of_memory,
    interrupted,
    illegal,        ///< the world refused an action, and no failure before explains it
    found_objects,  ///< objects that the task does not have (see `explore`)
    contradiction,  ///< a reading contradicts what is known
};
const char* to_string(RunStatus status);

/// One step of the run, for traces.
struct Event {
    enum class Kind : std::uint8_t { planned, executed, failed, read, finished, supposed, found };
    Kind kind = Kind::planned;
    std::uint32_t action = Environment::kStart;  ///< executed, failed
    /// Why planned, why failed, what was read, how finished, what is supposed after failures, what was
    /// found.
    std::string text;
    std::vector<std::uint32_t> plan = {};  ///< planned: the actions of the plan
    double seconds = 0;                    ///< planned: processor time
};

struct RunResult {
    RunStatus status = RunStatus::not_found;
    std::vector<std::uint32_t> actions;  ///< executed, in order; operators of the physical task
    std::size_t plans = 0;
    std::vector<double> plan_seconds;  ///< processor seconds of each search
    std::string message;
};

class Agent {
  public:
    Agent(std::shared_ptr<const KnowledgePlanner> planner, AgentOptions options = default_agent_options());

    /// Acts until the goal is known, or something ends the run. `watch` is told of every event.
    RunResult run(Belief& belief, Environment& environment, const Budget& budget = {},
                  const std::function<void(const Event&, const Belief&)>& watch = {}) const;

  private:
    class Run;
    std::shared_ptr<const KnowledgePlanner> planner_;
    AgentOptions options_;
};

}  // namespace praxis::belief
