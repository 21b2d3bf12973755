// From syntax trees to a checked task.
#pragma once

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

/// Resolves every name and checks everything that can be checked without grounding. Mistakes go to the
/// reporter; the task is whole only if there are none.
LiftedTask check(const syntax::Tree& domain, const syntax::Tree& problem, const syntax::SymbolTable& symbols,
                 Reporter& reporter);

/// The same into the context's task, and without a look at goals that no action reaches. Returns an index
/// over the initial atoms of each predicate.
std::vector<TupleIndex> check_task(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);

/// Its first steps: names of the files, types, objects; and then, when all objects are there, predicates and
/// functions.
void check_head(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);
void check_declarations(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);

}  // namespace praxis::check
