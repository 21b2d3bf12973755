// What a refined plan costs, with the functions' values for the values that were sampled.
#pragma once

#include <span>
#include <vector>

#include "tamp/refine/samples.hpp"
#include "tamp/refine/skeleton.hpp"

namespace praxis::tamp {

/// By the task's metric; `values` by slot. Throws StreamError as the functions' callbacks make it.
double plan_cost(const StreamTask& streams, const Skeleton& skeleton, const Samples& samples,
                 std::span<const ValueNumber> values);

}  // namespace praxis::tamp
