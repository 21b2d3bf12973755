// Numeric expressions over constants and static functions.
#pragma once

#include "parser/check/scope.hpp"

namespace praxis::check {

/// The expression of a node, as an action's cost. Empty if something is wrong.
std::optional<Expression> check_cost(ScopeBuilder& scope, syntax::NodeIndex index);

}  // namespace praxis::check
