// What streams certify may only make more possible.
#pragma once

#include "parser/check/context.hpp"
#include "parser/streams.hpp"

namespace praxis::check {

/// Reports conditions that hold only where a certified atom does not, and effects that depend on one.
void check_monotone(Context& context, const std::vector<bool>& certified);

}  // namespace praxis::check
