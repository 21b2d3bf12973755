// Capsules of robots whose format has none.
#pragma once

#include <vector>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// Replaces every cylinder that has balls of its radius at both ends by a capsule, which is the same solid
/// and cheaper to check; balls that no capsule needs stay. Equal means: to a micrometre.
void merge_capsules(std::vector<PlacedShape>& shapes);

}  // namespace praxis::tamp
