// Effects, flattened into single adds and deletes, and the cost of an action.
#pragma once

#include "parser/check/scope.hpp"

namespace praxis::check {

/// Adds the effects of a node to a schema.
void check_effects(ScopeBuilder& scope, syntax::NodeIndex index, Schema& schema);

}  // namespace praxis::check
