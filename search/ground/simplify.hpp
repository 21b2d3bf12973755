// Simplifies ground axioms: derived atoms that always or never hold, or that only rename or join other
// literals, go away.
#pragma once

#include "search/ground/proposition_task.hpp"

namespace praxis::grounding {

/// Decides what can be decided without a state, stratum by stratum, and rewrites operators, axioms and goal
/// accordingly. Returns false, changing nothing, if an atom depends on its own negation.
[[nodiscard]] bool simplify_axioms(PropositionTask& task);

/// By derived atom (other entries are -1): the layer in which it is computed; only axioms of lower layers are
/// read negated. Empty if an atom depends on its own negation.
std::vector<std::int32_t> axiom_layers(const PropositionTask& task);

}  // namespace praxis::grounding
