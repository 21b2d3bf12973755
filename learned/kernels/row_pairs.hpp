// Two rows of a 3x3 convolution at once by Winograd's minimal filtering F(2, 3) in the vertical direction
// (Lavin and Gray, Fast algorithms for convolutional neural networks, CVPR 2016).
//
// Four rows d0..d3 of input and the three rows g0..g2 of a filter give two rows of output by four products in
// place of six:
//
//     m0 = (d0 - d2) g0        m1 = (d1 + d2) (g0 + g1 + g2) / 2        y0 = m0 + m1 + m2
//     m3 = (d1 - d3) g2        m2 = (d2 - d1) (g0 - g1 + g2) / 2        y1 = m1 - m2 - m3
//
// The products are horizontal convolutions of three taps each. Results differ from the direct ones by
// rounding alone.
#pragma once

#include <span>
#include <vector>

#include "learned/kernels/kernels.hpp"

namespace praxis::learned {

/// A filter [input][3x3][output] as [product][input][3][output].
template <class T>
void pair_filter(int inputs, int outputs, std::span<const T> filter, std::vector<T>& paired) {
    const auto row = static_cast<std::size_t>(3 * outputs), products = static_cast<std::size_t>(inputs) * row;
    paired.resize(4 * products);
    for (std::size_t i = 0; i < static_cast<std::size_t>(inputs); ++i)
        for (std::size_t k = 0; k < row; ++k) {
            const T *g = &filter[3 * i * row + k], g0 = g[0], g1 = g[row], g2 = g[2 * row];
            T* const to = &paired[i * row + k];
            to[0] = g0;
            to[products] = (g0 + g1 + g2) / 2;
            to[2 * products] = (g0 - g1 + g2) / 2;
            to[3 * products] = g2;
        }
}

/// Numbers that backup_by_pairs needs to keep its sums of rows, for values with rows of this stride.
inline std::size_t row_pair_scratch(const BackupShape& shape, std::ptrdiff_t stride) {
    return static_cast<std::size_t>((shape.height + 1) / 2 * 4 * shape.order * stride + kRowUnit);
}

}  // namespace praxis::learned
