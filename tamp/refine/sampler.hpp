// Values for a skeleton: conflict-directed backjumping over the nodes (Prosser, "Hybrid algorithms for the
// constraint satisfaction problem", 1993).
//
// Nodes are tried in an order that respects their dependencies and calls cheap streams first. A node that has
// no further sample jumps back to the last node that is to blame: the ones that made the inputs, or the
// arguments of the fluents, which the rejections blamed; and of nodes whose samples all failed later, also
// what those failures blamed. If nothing is left to jump to, the nodes and fluents that were ever blamed on
// the way are the explanation.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tamp/refine/samples.hpp"
#include "tamp/refine/skeleton.hpp"

namespace praxis::tamp {

struct SampleLimits {
    std::uint32_t calls = 64;     ///< of callbacks, for the whole skeleton
    std::uint32_t attempts = 16;  ///< of one node for the same inputs, counted over all skeletons
    bool backjumping = true;
    bool blame = true;  ///< look at what rejections blame; otherwise it is all that the call was given
};

struct SampleOutcome {
    bool solved = false;
    std::vector<ValueNumber> values;  ///< by slot, if solved
    /// If not: no values exist, whatever is sampled. Otherwise a limit has cut something off.
    bool definite = true;
    std::vector<std::uint32_t> nodes;  ///< that explain the failure
    /// And of them these fluents: (node, fluent).
    std::vector<std::pair<std::uint32_t, std::uint32_t>> fluents;
    /// Each of these would explain it in place of `fluents`, of which there is one then.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> others;
};

/// Values for the skeleton, or one failure; behind it, failures of other nodes that need nothing that is
/// sampled and fail by themselves. Never empty.
std::vector<SampleOutcome> sample(const SymbolicTask& task, const Skeleton& skeleton, Samples& samples,
                                  const SampleLimits& limits, const Budget& budget);

}  // namespace praxis::tamp
