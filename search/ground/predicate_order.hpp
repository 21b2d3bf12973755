// The order in which predicates can be evaluated.
#pragma once

#include <vector>

#include "parser/task.hpp"

namespace praxis::grounding {

/// Strongly connected components of "occurs in an axiom of", each after those it depends on. Static and
/// fluent predicates are components of one.
std::vector<std::vector<PredicateId>> predicate_order(const LiftedTask& task);

}  // namespace praxis::grounding
