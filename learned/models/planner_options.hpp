// What makes up a planner network, in plain values: written into the weights file, and enough to build it
// again.
#pragma once

#include <string>

#include "learned/kernels/edges.hpp"

namespace praxis::learned {

/// How the gradient gets through the iterations.
enum class Differentiation : std::uint8_t {
    unrolled,  ///< backwards through each iteration; memory and time grow with their number
    implicit,  ///< at the fixed point, by the implicit function theorem; independent of their number
};

struct PlannerOptions {
    /// "vin" (with a group: SymVIN), "gru" (ConvGPPN; with a group: SymGPPN), "lstm" (GPPN).
    std::string model = "vin";
    std::string group = "c1";  ///< c1, c4 or d4
    /// Regular fields of the group: of Q for value iteration, of the hidden state otherwise.
    int fields = 40;
    int iterations = 30;
    int radius = 1;        ///< of the iterated filter: 1 (3x3) or 2 (5x5)
    int input_radius = 1;  ///< of the filter that reads the map: 1 or 2
    Padding padding = Padding::zero;
    /// Bound on the L1 norm of value iteration's filters: with at most 1, values cannot diverge; 0 is no
    /// bound.
    double contraction = 0.99;

    Differentiation differentiation = Differentiation::unrolled;
    /// Implicit: stop when no value changes by more than this, or after `iterations`.
    double tolerance = 1e-4;
    int backward_iterations = 15;
    int anderson = 5;  ///< steps that Anderson's method mixes on the way back; 0 is plain iteration

    bool operator==(const PlannerOptions&) const = default;
};

}  // namespace praxis::learned
