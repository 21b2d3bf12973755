// From syntax trees to a checked task.
#pragma once

#include "parser/check/context.hpp"

namespace praxis::check {

/// Resolves every name and checks everything that can be checked without grounding. Mistakes go to the
/// reporter; the task is whole only if there are none.
LiftedTask check(const syntax::Tree& domain, const syntax::Tree& problem, const syntax::SymbolTable& symbols,
                 Reporter& reporter);

/// Its first steps: names of the files, types, objects; and then, when all objects are there, predicates and
/// functions.
void check_head(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);
void check_declarations(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);

}  // namespace praxis::check
