// Predicates and functions.
#pragma once

#include "parser/check/context.hpp"

namespace praxis::check {

void declare_predicates(Context& context, const syntax::Tree& domain);
void declare_functions(Context& context, const syntax::Tree& domain);

/// Declares total-cost if a file uses it without a declaration, with a warning.
void declare_total_cost(Context& context, const syntax::Tree& tree);

/// Marks the heads of axioms as derived; to be called before effects are checked.
void mark_derived(Context& context, const syntax::Tree& domain);

}  // namespace praxis::check
