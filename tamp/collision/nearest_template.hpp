// The nearest of many points, over a type `Lanes` of eight floats; see kernel_template.hpp.
#pragma once

#include "tamp/collision/kernel.hpp"

namespace praxis::tamp::kernel {
namespace {

template <bool periodic>
inline int nearest_of(const float* blocks, int block_count, int dimension, const float* query,
                      const float* periods, float* squared) {
    Lanes best = 3e38F;
    Lanes best_block = 0.0F;
    for (int b = 0; b < block_count; ++b, blocks += kLanes * dimension) {
        Lanes sum = 0.0F;
        for (int d = 0; d < dimension; ++d) {
            Lanes difference = Lanes::load(blocks + d * kLanes) - Lanes(query[d]);
            if constexpr (periodic) {
                if (periods[d] > 0) {
                    const Lanes turns = rounded(difference * Lanes(1 / periods[d]));
                    difference = multiply_subtract(turns, periods[d], difference);
                }
            }
            sum = multiply_add(difference, difference, sum);
        }
        best_block = where_less(sum, best, static_cast<float>(b), best_block);
        best = minimum(sum, best);
    }
    alignas(32) float distances[kLanes];
    alignas(32) float places[kLanes];
    best.store(distances);
    best_block.store(places);
    int winner = 0;
    int place = kLanes * static_cast<int>(places[0]);
    for (int lane = 1; lane < kLanes; ++lane) {
        const int candidate = kLanes * static_cast<int>(places[lane]) + lane;
        if (distances[lane] < distances[winner] ||
            (distances[lane] == distances[winner] && candidate < place)) {
            winner = lane;
            place = candidate;
        }
    }
    *squared = distances[winner];
    return place;
}

int nearest(const float* blocks, int block_count, int dimension, const float* query, const float* periods,
            float* squared) {
    return periods != nullptr ? nearest_of<true>(blocks, block_count, dimension, query, periods, squared)
                              : nearest_of<false>(blocks, block_count, dimension, query, periods, squared);
}

}  // namespace
}  // namespace praxis::tamp::kernel
