// The :requirements of a domain against the features it uses.
#pragma once

#include "parser/check/context.hpp"

namespace praxis::check {

/// Warns once for each feature that is used but not announced, and of unknown flags.
void check_requirements(Context& context, const syntax::Tree& domain, const syntax::Tree& problem);

}  // namespace praxis::check
