// What lies behind the edge of a map.
#pragma once

#include <cstdint>

namespace praxis::learned {

/// Nothing, or (angles, tori) the opposite edge.
enum class Padding : std::uint8_t { zero, circular };

/// Calls visit(row, column, source_row, source_column) for each halo cell and the cell at the opposite edge
/// that circular padding copies there.
template <class Visit>
void for_halo(int height, int width, int halo, const Visit& visit) {
    const auto wrapped = [](int at, int size) {
        while (at < 0) at += size;
        while (at >= size) at -= size;
        return at;
    };
    for (int row = -halo; row < height + halo; ++row) {
        const bool inside = row >= 0 && row < height;
        for (int column = -halo; column < width + halo; ++column) {
            if (inside && column == 0) column = width;
            visit(row, column, wrapped(row, height), wrapped(column, width));
        }
    }
}

}  // namespace praxis::learned
