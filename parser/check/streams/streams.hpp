// Streams and external functions against the domain and problem that they are for.
#pragma once

#include "parser/check/context.hpp"
#include "parser/streams.hpp"

namespace praxis::check {

/// Fills in the streams, functions and `certified` of a task that has been checked into `context.task`.
/// Mistakes are reported.
void check_streams(Context& context, const syntax::Tree& tree, StreamTask& result);

}  // namespace praxis::check
