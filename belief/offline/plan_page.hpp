// A conditional plan as one self-contained page: counts, a drawing (inline SVG, nothing is loaded from
// elsewhere) and an outline that folds.
//
// The graph is drawn as a tree: where a stretch of actions has been drawn before, a link leads to it.
#pragma once

#include <string>

#include "belief/belief_task.hpp"
#include "belief/offline/conditional_plan.hpp"

namespace praxis::belief {

/// `title`: the page's heading. `summary`: a line below it. Plans of more than kMostDrawn stretches get the
/// outline alone.
std::string plan_to_html(const BeliefTask& task, const ConditionalPlan& plan, const std::string& title,
                         const std::string& summary);
inline constexpr std::size_t kMostDrawn = 3'000;

}  // namespace praxis::belief
