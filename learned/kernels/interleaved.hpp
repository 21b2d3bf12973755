// Fields in memory cell by cell: all channels of a cell side by side. What scatters from single cells works
// on them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "learned/kernels/planes.hpp"

namespace praxis::learned {

template <class T>
class Interleaved {
  public:
    Interleaved() = default;
    Interleaved(int channels, int height, int width, int halo)
        : channels_(channels),
          height_(height),
          width_(width),
          halo_(halo),
          stride_(width + 2 * halo),
          cells_(static_cast<std::size_t>(stride_ * (height + 2 * halo) * channels)) {}

    int channels() const { return channels_; }
    /// The channels of cell (row, column), halo included.
    T* at(int row, int column) { return cells_.data() + index(row, column); }
    const T* at(int row, int column) const { return cells_.data() + index(row, column); }
    /// Stride in cells, no planes.
    View<T> view() { return {at(0, 0), stride_, 0}; }
    View<const T> view() const { return {at(0, 0), stride_, 0}; }

    void clear() { std::ranges::fill(cells_, T(0)); }
    std::vector<T>& cells() { return cells_; }
    const std::vector<T>& cells() const { return cells_; }

    /// Copies planes of the same size, with as much halo.
    void gather(const Planes<T>& planes) {
        for (int row = -halo_; row < height_ + halo_; ++row) {
            const T* const from = &planes.at(0, row, -halo_);
            T* const to = at(row, -halo_);
            for (std::ptrdiff_t column = 0; column < stride_; ++column)
                for (int channel = 0; channel < channels_; ++channel)
                    to[column * channels_ + channel] = from[channel * planes.plane() + column];
        }
    }
    /// The transpose of padding: see Planes::fold.
    void fold(Padding padding) {
        for_halo(height_, width_, halo_, [&](int row, int column, int from_row, int from_column) {
            T* const outside = at(row, column);
            T* const inside = at(from_row, from_column);
            for (int channel = 0; channel < channels_; ++channel) {
                if (padding == Padding::circular) inside[channel] += outside[channel];
                outside[channel] = T(0);
            }
        });
    }

  private:
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(((row + halo_) * stride_ + column + halo_) * channels_);
    }

    int channels_ = 0, height_ = 0, width_ = 0, halo_ = 0;
    std::ptrdiff_t stride_ = 0;
    std::vector<T> cells_;
};

}  // namespace praxis::learned
