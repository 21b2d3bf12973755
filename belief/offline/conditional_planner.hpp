// Makes a conditional plan by following classical plans about knowledge, and planning again wherever
// something may be read that the plan did not hope for.
//
// Every belief on the way is kept twice where the first states can be counted: as the agent keeps it
// (Belief), to plan from, and as the set of true states, which is exact: what the set knows is told to the
// belief, only answers that occur in the set get an edge, and one set gets one node. A set in whose every
// state the plan of a finished node works gets that node. Where the first states cannot be counted, beliefs
// are told apart by their fingerprints and every answer that does not contradict them gets an edge.
//
// Sets never grow along a plan, so that a plan can come back to a set only before the next reading that
// splits it: such loops are cut out, and the belief where the loop closed is planned for again with another
// seed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "belief/knowledge_planner.hpp"
#include "belief/offline/conditional_plan.hpp"
#include "belief/offline/optimal_policy.hpp"
#include "belief/worlds.hpp"

namespace praxis::belief {

struct ConditionalPlannerOptions {
    Configuration first;   ///< the search for each plan
    Configuration second;  ///< goes on where the first finds none in `plan_seconds`
    double plan_seconds = 2;
    /// Where finished nodes serve further sets of states.
    enum class Reuse : std::uint8_t { never, after_answers, everywhere };
    Reuse reuse = Reuse::after_answers;
    std::size_t most_nodes = 100'000;
    std::size_t most_plans = 100'000;
    std::size_t most_returns = 8;       ///< plans for one belief
    std::size_t most_outcomes = 4'096;  ///< of one action
};

struct ConditionalPlanResult {
    enum class Status : std::uint8_t {
        found,
        none,       ///< there is a belief from which no plan leads on, whatever is read
        not_found,  ///< a search failed, or beliefs kept coming back
        limit,      ///< nodes, plans, time or memory
    };
    Status status = Status::not_found;
    std::string message;
    ConditionalPlan plan;    ///< found
    std::size_t plans = 0;   ///< classical plans made
    std::size_t reused = 0;  ///< sets that got the node of another
};

/// `worlds`: all first states; nothing where they cannot be counted.
ConditionalPlanResult make_conditional_plan(const KnowledgePlanner& planner,
                                            const std::optional<std::vector<WorldState>>& worlds,
                                            const ConditionalPlannerOptions& options,
                                            const Budget& budget = {});

}  // namespace praxis::belief
