// In which order the inner points of a motion are checked.
#pragma once

#include <bit>
#include <cstddef>

namespace praxis::tamp {

/// Calls `visit(i)` for each i of 1..count-1 once, coarse to fine (the middle, then the quarters, ...), so
/// that contacts are met early; until `visit` returns false. Whether none did.
template <class Visit>
bool coarse_to_fine(std::size_t count, Visit&& visit) {
    for (std::size_t stride = std::bit_ceil(count) / 2; stride > 0; stride /= 2) {
        for (std::size_t i = stride; i < count; i += 2 * stride) {
            if (!visit(i)) return false;
        }
    }
    return true;
}

}  // namespace praxis::tamp
