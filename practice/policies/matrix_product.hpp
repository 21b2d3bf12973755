// C += A B for the small matrices of a perceptron. A tile of C is kept in registers while the inner dimension
// passes by; four columns go through one vector instruction, of the plainest instruction set, so that results
// are the same on every machine of an architecture.
#pragma once

#include <cstddef>
#include <cstring>

namespace praxis::practice {

/// A matrix that is read in steps: element (i, j) lies at `data[i * row_step + j * column_step]`.
struct StridedMatrix {
    const float* data;
    std::size_t row_step, column_step;
};

namespace detail {

using FourFloats __attribute__((vector_size(16))) = float;

inline FourFloats load(const float* from) {
    FourFloats result;
    std::memcpy(&result, from, sizeof result);
    return result;
}

/// Columns in vectors: `kRows` rows of `kVectors` times four columns.
template <std::size_t kRows, std::size_t kVectors>
inline void add_tile(StridedMatrix a, const float* b, float* c, std::size_t inner, std::size_t columns) {
    FourFloats sum[kRows][kVectors];
#pragma GCC unroll 8
    for (std::size_t r = 0; r < kRows; ++r)
#pragma GCC unroll 8
        for (std::size_t v = 0; v < kVectors; ++v) sum[r][v] = load(c + r * columns + 4 * v);
    for (std::size_t k = 0; k < inner; ++k) {
        const float* const row = b + k * columns;
#pragma GCC unroll 8
        for (std::size_t r = 0; r < kRows; ++r) {
            const float factor = a.data[r * a.row_step + k * a.column_step];
#pragma GCC unroll 8
            for (std::size_t v = 0; v < kVectors; ++v) sum[r][v] += factor * load(row + 4 * v);
        }
    }
#pragma GCC unroll 8
    for (std::size_t r = 0; r < kRows; ++r)
#pragma GCC unroll 8
        for (std::size_t v = 0; v < kVectors; ++v)
            std::memcpy(c + r * columns + 4 * v, &sum[r][v], sizeof(FourFloats));
}

/// All rows of some columns.
template <std::size_t kRows, std::size_t kVectors>
inline void add_strip(StridedMatrix a, const float* b, float* c, std::size_t rows, std::size_t inner,
                      std::size_t columns) {
    std::size_t i = 0;
    for (; i + kRows <= rows; i += kRows)
        add_tile<kRows, kVectors>({a.data + i * a.row_step, a.row_step, a.column_step}, b, c + i * columns,
                                  inner, columns);
    for (; i < rows; ++i)
        add_tile<1, kVectors>({a.data + i * a.row_step, a.row_step, a.column_step}, b, c + i * columns, inner,
                              columns);
}

/// One column; several rows at once, as each is a chain of additions.
inline void add_column(StridedMatrix a, const float* b, float* c, std::size_t rows, std::size_t inner,
                       std::size_t columns) {
    constexpr std::size_t kRows = 8;
    std::size_t i = 0;
    for (; i + kRows <= rows; i += kRows) {
        float sum[kRows] = {};
        for (std::size_t k = 0; k < inner; ++k)
            for (std::size_t r = 0; r < kRows; ++r)
                sum[r] += a.data[(i + r) * a.row_step + k * a.column_step] * b[k * columns];
        for (std::size_t r = 0; r < kRows; ++r) c[(i + r) * columns] += sum[r];
    }
    for (; i < rows; ++i)
        for (std::size_t k = 0; k < inner; ++k)
            c[i * columns] += a.data[i * a.row_step + k * a.column_step] * b[k * columns];
}

}  // namespace detail

/// c (rows x columns) += a (rows x inner) * b (inner x columns); b and c lie row after row.
inline void add_product(StridedMatrix a, const float* b, float* c, std::size_t rows, std::size_t inner,
                        std::size_t columns) {
    std::size_t j = 0;
    for (; j + 16 <= columns; j += 16) detail::add_strip<2, 4>(a, b + j, c + j, rows, inner, columns);
    for (; j + 4 <= columns; j += 4) detail::add_strip<4, 1>(a, b + j, c + j, rows, inner, columns);
    for (; j < columns; ++j) detail::add_column(a, b + j, c + j, rows, inner, columns);
}

}  // namespace praxis::practice
