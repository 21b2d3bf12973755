// The inner loops of learned planners, compiled once an instruction set and chosen when the program runs.
//
// A field of values over a grid is stored as planes, one a channel (grid.hpp): a row of cells is contiguous,
// so that one vector register holds eight or sixteen neighbours. A filter of radius r has (2r+1)^2 taps, row
// by row, and is stored as [input][tap][output]. All kernels work on one map at a time: the values of a map
// stay in the first-level cache through all iterations, which a batch of maps would not.
//
// Every kernel exists for float, in which planners train and run, and for double, in which the same code is
// tested.
#pragma once

#include <cstddef>
#include <cstdint>

namespace praxis::learned {

/// A field in memory: cell (row, column) of a channel is at origin[channel * plane + row * stride + column].
template <class T>
struct View {
    T* origin = nullptr;
    std::ptrdiff_t stride = 0, plane = 0;
    operator View<const T>() const { return {origin, stride, plane}; }
};

/// The cells and channels that a convolution maps. Inputs have at least `radius` cells of halo on all sides;
/// every row may be read and written up to the next multiple of kRowUnit columns (behind `width`, outputs are
/// set to zero).
struct ConvolutionShape {
    int height = 0, width = 0;
    int radius = 1;  ///< 0, 1 or 2
    int inputs = 0, outputs = 0;
    int taps() const { return (2 * radius + 1) * (2 * radius + 1); }
    std::size_t weights() const {
        return static_cast<std::size_t>(inputs) * static_cast<std::size_t>(taps()) *
               static_cast<std::size_t>(outputs);
    }
};

/// Rows are computed in units of so many columns.
inline constexpr int kRowUnit = 16;

/// A step of value iteration: values[h] <- max over f < fields of rewards[h * fields + f] + filter(values).
/// Values have `order` channels, and so has the result; the filter has order * fields outputs.
struct BackupShape {
    int height = 0, width = 0;
    int radius = 1;  ///< 1 or 2
    int order = 1;   ///< 1, 4 or 8
    int fields = 0;  ///< 1 to 255
    int taps() const { return (2 * radius + 1) * (2 * radius + 1); }
};

template <class T>
struct Kernels {
    const char* name;

    /// output += filter(input).
    void (*convolve)(const ConvolutionShape&, View<const T> input, const T* filter, View<T> output);

    /// gradient of the filter, [input][tap][output], += what `of_output` says. `of_output` is zero behind
    /// `width`.
    void (*convolve_gradient)(const ConvolutionShape&, View<const T> input, View<const T> of_output,
                              T* of_filter);

    /// The step of value iteration. `best`, if not null, gets the maximising f of each (h, cell), laid out as
    /// rewards are without their fields: channel h, stride and plane of `rewards`.
    void (*backup)(const BackupShape&, View<const T> values, const T* filter, View<const T> rewards,
                   View<T> result, std::uint8_t* best);

    /// The same step for 3x3 filters, rows in pairs, a third fewer multiplications (row_pairs.hpp): worth it
    /// if `order` is 4 or 8. `scratch` holds row_pair_scratch(shape, values.stride) numbers.
    void (*backup_by_pairs)(const BackupShape&, View<const T> values, const T* paired_filter,
                            View<const T> rewards, View<T> result, std::uint8_t* best, T* scratch);

    /// The transpose of that step at given maximisers. Values and their gradients are interleaved here (all
    /// channels of a cell side by side; stride in cells, plane unused). `turned` is the filter as
    /// [output][tap][input]. Adds to of_values (whose halo collects what leaves the map), and, where not
    /// null, to of_turned and of_rewards.
    void (*backup_gradient)(const BackupShape&, View<const T> values, const T* turned,
                            const std::uint8_t* best, View<const T> of_result, View<T> of_values,
                            T* of_turned, View<T> of_rewards);

    /// x <- 1 / (1 + exp(-x)) and x <- tanh(x), for `count` values.
    void (*sigmoid)(T* x, std::size_t count);
    void (*tanh)(T* x, std::size_t count);
};

/// The instruction sets that are compiled in.
enum class Instructions : std::uint8_t { portable, avx2, avx512 };

/// True if this processor runs them and they are compiled in.
bool supported(Instructions instructions);

/// The kernels of an instruction set; std::invalid_argument if it is not supported here.
template <class T>
const Kernels<T>& kernels(Instructions instructions);

/// The kernels for this processor.
template <class T>
const Kernels<T>& kernels();

}  // namespace praxis::learned
