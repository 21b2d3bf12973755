// Conditional plans as texts: for people, for Graphviz, for programs.
#pragma once

#include <string>

#include "belief/belief_task.hpp"
#include "belief/offline/conditional_plan.hpp"

namespace praxis::belief {

/// Numbered stretches of actions with "if ...: go to N" after them.
std::string plan_to_text(const BeliefTask& task, const ConditionalPlan& plan);

/// A directed graph in Graphviz's language.
std::string plan_to_dot(const BeliefTask& task, const ConditionalPlan& plan);

/// {"nodes": [{"id": 0, "action": "(smell p1-1)", "edges": [{"if": [{"atom": "(stench p1-1)", "holds":
/// true}], "to": 1}, ...]}, ..., {"id": 9, "goal": true}], "action_nodes": 9, "edges": 10, "depth": 7}.
/// "holds" is null where nothing is answered; a node without "action" and "goal" only takes in what is read
/// at first.
std::string plan_to_json(const BeliefTask& task, const ConditionalPlan& plan);

}  // namespace praxis::belief
