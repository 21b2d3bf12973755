// Uniform reals from praxis::Random.
#pragma once

#include "search/engines/random.hpp"

namespace praxis::learned {

/// In [low, high).
inline double uniform(Random& random, double low = 0, double high = 1) {
    return low + (high - low) * (static_cast<double>(random.next() >> 11) * 0x1p-53);
}

}  // namespace praxis::learned
