// Multi-valued variables: `:variable` and `:obs-variable`, made ground.
#pragma once

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

/// Expands the declarations of a tree over all objects; `when` in front of values is evaluated in the initial
/// state. Variables without any value are left out.
void check_variables(Context& context, const syntax::Tree& tree,
                     const std::vector<TupleIndex>& initial_atoms);

}  // namespace praxis::check
