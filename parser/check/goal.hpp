// The goal and the metric.
#pragma once

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

void check_goal(Context& context, const syntax::Tree& problem);
void check_metric(Context& context, const syntax::Tree& problem);

/// Warns of facts of the goal that are false and that no action changes.
void check_static_goals(Context& context, const std::vector<TupleIndex>& initial_atoms);

}  // namespace praxis::check
