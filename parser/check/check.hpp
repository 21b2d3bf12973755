// From syntax trees to a checked task.
#pragma once

#include "parser/reporter.hpp"
#include "parser/syntax/tree.hpp"
#include "parser/task.hpp"

namespace praxis::check {

/// Resolves every name and checks everything that can be checked without grounding. Mistakes go to the
/// reporter; the task is whole only if there are none.
LiftedTask check(const syntax::Tree& domain, const syntax::Tree& problem, const syntax::SymbolTable& symbols,
                 Reporter& reporter);

}  // namespace praxis::check
