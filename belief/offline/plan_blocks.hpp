// A conditional plan as people read it: stretches of actions without a choice, and what to do after each
// answer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/offline/conditional_plan.hpp"

namespace praxis::belief {

struct PlanBlock {
    static constexpr std::uint32_t kGoal = 0xffffffff;
    struct Choice {
        std::vector<std::string>
            answers;           ///< "(smell p1-1)", "not (smell p1-1)", "nothing about (smell p1-1)"
        std::uint32_t target;  ///< number of a block; kGoal
    };
    std::vector<std::string> actions;  ///< "(move p1-1 p1-2)", in order; empty: only what is read at first
    std::vector<Choice> choices;       ///< after the last action; one without answers: go on there
};

/// Block 0 is the first; a block comes before those it leads to. No blocks: there is nothing to do.
std::vector<PlanBlock> plan_blocks(const BeliefTask& task, const ConditionalPlan& plan);

/// How a report reads.
std::string report_text(const BeliefTask& task, const ConditionalPlan::Report& report);
/// The atom that a report is about: "(smell p1-1)".
std::string report_atom(const BeliefTask& task, std::int32_t variable);
/// Whether that atom holds if the variable has the value.
bool report_holds(const BeliefTask& task, const ConditionalPlan::Report& report);

}  // namespace praxis::belief
