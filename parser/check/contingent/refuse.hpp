// What a classical task cannot have.
#pragma once

#include <string_view>

#include "parser/check/context.hpp"

namespace praxis::check {

inline constexpr std::string_view kBeliefHint = "'plan belief' plans such tasks";

/// Reports the sections of partial observability, and objects declared in the wrong file.
void refuse_contingent(Context& context, const syntax::Tree& tree);

}  // namespace praxis::check
