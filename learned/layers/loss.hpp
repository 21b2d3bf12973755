// What a policy is trained on: the cross-entropy of its moves, and its gradient.
#pragma once

#include "learned/kernels/planes.hpp"
#include "learned/maps/map_problem.hpp"

namespace praxis::learned {

enum class Loss : std::uint8_t {
    /// -log of the probability of all optimal moves together, over cells that reach the goal.
    all_optimal,
    /// -log of the probability of the label, over all cells, walls too: the loss of the published
    /// experiments.
    one_label,
};

/// The mean over the cells that count; of_policy is set to its gradient, times `weight`.
template <class T>
T policy_loss(Loss loss, const MapProblem& problem, const Planes<T>& policy, T weight, Planes<T>& of_policy);

}  // namespace praxis::learned
