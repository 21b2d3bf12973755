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
    const Lanes least = lowest(best);
    const Lanes place = multiply_add(best_block, static_cast<float>(kLanes), Lanes::ascending());
    alignas(32) float result[kLanes];
    least.store(result);
    *squared = result[0];
    lowest(where_less(least, best, 3e38F, place)).store(result);
    return static_cast<int>(result[0]);
}

int nearest(const float* blocks, int block_count, int dimension, const float* query, const float* periods,
            float* squared) {
    return periods != nullptr ? nearest_of<true>(blocks, block_count, dimension, query, periods, squared)
                              : nearest_of<false>(blocks, block_count, dimension, query, periods, squared);
}

}  // namespace
}  // namespace praxis::tamp::kernel
