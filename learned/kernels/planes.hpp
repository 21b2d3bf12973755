// Fields over a grid in memory: planes with a halo, and what has to be done at its edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "learned/kernels/edges.hpp"
#include "learned/kernels/kernels.hpp"

namespace praxis::learned {

/// `channels` planes of height x width cells with `halo` cells around each; all zero at first.
template <class T>
class Planes {
  public:
    Planes() = default;
    Planes(int channels, int height, int width, int halo)
        : channels_(channels),
          height_(height),
          width_(width),
          halo_(halo),
          stride_((width + kRowUnit - 1) / kRowUnit * kRowUnit + (halo > 0 ? kHaloUnit : 0)),
          plane_(stride_ * (height + 2 * halo)),
          cells_(static_cast<std::size_t>(plane_ * channels + kRowUnit)) {}

    int channels() const { return channels_; }
    int height() const { return height_; }
    int width() const { return width_; }
    int halo() const { return halo_; }
    std::ptrdiff_t stride() const { return stride_; }
    std::ptrdiff_t plane() const { return plane_; }

    /// Cell (row, column) of a channel; -halo <= row, column < size + halo.
    T& at(int channel, int row, int column) { return cells_[index(channel, row, column)]; }
    const T& at(int channel, int row, int column) const { return cells_[index(channel, row, column)]; }

    /// From a channel on.
    View<T> view(int channel = 0) { return {&at(channel, 0, 0), stride_, plane_}; }
    View<const T> view(int channel = 0) const { return {&at(channel, 0, 0), stride_, plane_}; }

    void clear() { std::ranges::fill(cells_, T(0)); }
    /// Everything that is stored, halo and all, plane by plane; a multiple of kRowUnit.
    T* data() { return cells_.data(); }
    const T* data() const { return cells_.data(); }
    std::size_t size() const { return cells_.size(); }

    /// Writes the halo: zeros, or copies of the opposite edge.
    void pad(Padding padding) {
        for (int channel = 0; channel < channels_; ++channel)
            for_halo(height_, width_, halo_, [&](int row, int column, int from_row, int from_column) {
                at(channel, row, column) =
                    padding == Padding::circular ? at(channel, from_row, from_column) : T(0);
            });
    }
    /// The transpose of pad: what is in the halo is dropped, or added to the opposite edge; then the halo is
    /// zero.
    void fold(Padding padding) {
        for (int channel = 0; channel < channels_; ++channel)
            for_halo(height_, width_, halo_, [&](int row, int column, int from_row, int from_column) {
                T& outside = at(channel, row, column);
                if (padding == Padding::circular) at(channel, from_row, from_column) += outside;
                outside = T(0);
            });
    }

  private:
    static constexpr int kHaloUnit = 8;

    std::size_t index(int channel, int row, int column) const {
        return static_cast<std::size_t>(channel * plane_ + (row + halo_) * stride_ + column + halo_);
    }

    int channels_ = 0, height_ = 0, width_ = 0, halo_ = 0;
    std::ptrdiff_t stride_ = 0, plane_ = 0;
    std::vector<T> cells_;
};

}  // namespace praxis::learned
