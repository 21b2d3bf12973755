// Conditions: preconditions, goals, bodies of axioms, conditions of effects.
#pragma once

#include "parser/check/scope.hpp"

namespace praxis::check {

/// The formula of a node; `truth` for kNoNode. Mistakes are reported.
Formula check_condition(ScopeBuilder& scope, syntax::NodeIndex index);

}  // namespace praxis::check
