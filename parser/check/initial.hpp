// The initial state.
#pragma once

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

/// Fills in initial_atoms and initial_values; returns an index over the atoms of each predicate.
std::vector<TupleIndex> check_initial_state(Context& context, const syntax::Tree& problem);

}  // namespace praxis::check
