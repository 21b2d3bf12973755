// Actions and axioms.
#pragma once

#include "parser/check/context.hpp"

namespace praxis::check {

void check_schemas(Context& context, const syntax::Tree& domain);
void check_axioms(Context& context, const syntax::Tree& domain);

}  // namespace praxis::check
