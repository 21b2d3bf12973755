// The kernels, written once with vectors of PRAXIS_VECTOR_BYTES bytes, PRAXIS_VECTORS of them a block of
// columns. Included only by the files that compile it for one instruction set each, with namespace
// PRAXIS_KERNELS. No inline function of another header may be used here: the linker could keep the copy that
// was compiled for an instruction set that the processor lacks.
#include "learned/kernels/variants.hpp"

namespace praxis::learned::PRAXIS_KERNELS {
namespace {

using Index = std::ptrdiff_t;

constexpr int kVectors = PRAXIS_VECTORS;
constexpr int kMaxBlock = 5;  // outputs at once: with two vectors each and two of input, 12 of 16 registers

template <class T>
struct Lanes {
    static constexpr int kCount = PRAXIS_VECTOR_BYTES / static_cast<int>(sizeof(T));
    static constexpr int kColumns = kVectors * kCount;
    typedef T Vector __attribute__((vector_size(PRAXIS_VECTOR_BYTES)));
    typedef std::uint8_t Bytes __attribute__((vector_size(kCount)));
    static_assert(kRowUnit % kColumns == 0);
};

template <class T>
using Vector = typename Lanes<T>::Vector;

template <class V, class T>
inline V load(const T* from) {
    V vector;
    __builtin_memcpy(&vector, from, sizeof(V));
    return vector;
}
template <class V, class T>
inline void store(const V& vector, T* to) {
    __builtin_memcpy(to, &vector, sizeof(V));
}

template <class T>
struct ColumnMask {
    T values[2 * Lanes<T>::kColumns] = {};
    constexpr ColumnMask() {
        for (int column = 0; column < Lanes<T>::kColumns; ++column) values[column] = 1;
    }
};

// One where a column of the block lies in the map, zero behind it.
template <class T>
inline void column_mask(int first, int width, Vector<T> (&mask)[kVectors]) {
    static constexpr ColumnMask<T> kMask;
    const int inside = width - first < Lanes<T>::kColumns ? width - first : Lanes<T>::kColumns;
    for (int v = 0; v < kVectors; ++v)
        mask[v] = load<Vector<T>>(kMask.values + Lanes<T>::kColumns - inside + v * Lanes<T>::kCount);
}

// sums[b] += filter(input) at one block of columns, for the outputs b < Block from `filter` on.
template <class T, int Radius, int Block>
inline void accumulate(Vector<T> (&sums)[Block][kVectors], const T* input, Index stride, Index plane,
                       int inputs, const T* filter, Index outputs) {
    for (int i = 0; i < inputs; ++i) {
        const T* row = input + i * plane - Radius * stride - Radius;
        for (int y = 0; y <= 2 * Radius; ++y, row += stride) {
            for (int x = 0; x <= 2 * Radius; ++x, filter += outputs) {
                Vector<T> values[kVectors];
                for (int v = 0; v < kVectors; ++v)
                    values[v] = load<Vector<T>>(row + x + v * Lanes<T>::kCount);
                for (int b = 0; b < Block; ++b)
                    for (int v = 0; v < kVectors; ++v) sums[b][v] += values[v] * filter[b];
            }
        }
    }
}

// Calls body.template operator()<N>(first) for blocks of N <= kMaxBlock outputs that cover 0..outputs-1
// evenly.
template <class Body>
inline void for_blocks(int outputs, const Body& body) {
    const int blocks = (outputs + kMaxBlock - 1) / kMaxBlock;
    for (int k = 0, first = 0; k < blocks; ++k) {
        const int size = (outputs - first) / (blocks - k);
        switch (size) {
            case 1:
                body.template operator()<1>(first);
                break;
            case 2:
                body.template operator()<2>(first);
                break;
            case 3:
                body.template operator()<3>(first);
                break;
            case 4:
                body.template operator()<4>(first);
                break;
            default:
                body.template operator()<5>(first);
                break;
        }
        first += size;
    }
}

template <class T, int Radius>
void convolve_radius(const ConvolutionShape& shape, View<const T> input, const T* filter, View<T> output) {
    for (int column = 0; column < shape.width; column += Lanes<T>::kColumns) {
        Vector<T> mask[kVectors] = {};
        column_mask<T>(column, shape.width, mask);
        for_blocks(shape.outputs, [&]<int Block>(int first) {
            for (int row = 0; row < shape.height; ++row) {
                T* const to = output.origin + first * output.plane + row * output.stride + column;
                Vector<T> sums[Block][kVectors];
                for (int b = 0; b < Block; ++b)
                    for (int v = 0; v < kVectors; ++v)
                        sums[b][v] = load<Vector<T>>(to + b * output.plane + v * Lanes<T>::kCount);
                accumulate<T, Radius, Block>(sums, input.origin + row * input.stride + column, input.stride,
                                             input.plane, shape.inputs, filter + first, shape.outputs);
                for (int b = 0; b < Block; ++b)
                    for (int v = 0; v < kVectors; ++v)
                        store(sums[b][v] * mask[v], to + b * output.plane + v * Lanes<T>::kCount);
            }
        });
    }
}

template <class T>
void convolve(const ConvolutionShape& shape, View<const T> input, const T* filter, View<T> output) {
    switch (shape.radius) {
        case 0:
            return convolve_radius<T, 0>(shape, input, filter, output);
        case 1:
            return convolve_radius<T, 1>(shape, input, filter, output);
        default:
            return convolve_radius<T, 2>(shape, input, filter, output);
    }
}

template <class T>
inline T sum(const Vector<T>& vector) {
    T total = 0;
    for (int lane = 0; lane < Lanes<T>::kCount; ++lane) total += vector[lane];
    return total;
}

template <class T, int Radius>
void convolve_gradient_radius(const ConvolutionShape& shape, View<const T> input, View<const T> of_output,
                              T* of_filter) {
    constexpr int kSide = 2 * Radius + 1;
    for (int i = 0; i < shape.inputs; ++i)
        for (int o = 0; o < shape.outputs; ++o) {
            const T* const from = input.origin + i * input.plane - Radius * input.stride - Radius;
            const T* const gradient = of_output.origin + o * of_output.plane;
            T* const to = of_filter + i * kSide * kSide * shape.outputs + o;
            for (int y = 0; y < kSide; y += 3) {  // at most 15 accumulators
                constexpr int kRows = kSide < 3 ? kSide : 3;
                Vector<T> sums[kRows][kSide] = {};
                const int rows = kSide - y < kRows ? kSide - y : kRows;
                for (int row = 0; row < shape.height; ++row)
                    for (int column = 0; column < shape.width; column += Lanes<T>::kCount) {
                        const auto g = load<Vector<T>>(gradient + row * of_output.stride + column);
                        for (int r = 0; r < kRows; ++r) {
                            if (r >= rows) break;
                            for (int x = 0; x < kSide; ++x) {
                                const auto value =
                                    load<Vector<T>>(from + (row + y + r) * input.stride + column + x);
                                sums[r][x] += g * value;
                            }
                        }
                    }
                for (int r = 0; r < rows; ++r)
                    for (int x = 0; x < kSide; ++x)
                        to[((y + r) * kSide + x) * shape.outputs] += sum<T>(sums[r][x]);
            }
        }
}

template <class T>
void convolve_gradient(const ConvolutionShape& shape, View<const T> input, View<const T> of_output,
                       T* of_filter) {
    switch (shape.radius) {
        case 0:
            return convolve_gradient_radius<T, 0>(shape, input, of_output, of_filter);
        case 1:
            return convolve_gradient_radius<T, 1>(shape, input, of_output, of_filter);
        default:
            return convolve_gradient_radius<T, 2>(shape, input, of_output, of_filter);
    }
}

// Takes the maximum over a block of fields from `field` on at one block of columns; if it is not the first
// block, over the blocks before it too, whose maxima are in `result` and `best` already.
template <class T, int Block, bool Record>
inline void take_maximum(const Vector<T> (&sums)[Block][kVectors], const Vector<T> (&mask)[kVectors],
                         int field, T* result, std::uint8_t* best) {
    constexpr int kLanes = Lanes<T>::kCount;
    using Bytes = typename Lanes<T>::Bytes;
    for (int v = 0; v < kVectors; ++v) {
        T* const to = result + v * kLanes;
        Vector<T> maximum = sums[0][v], which = Vector<T>{} + static_cast<T>(field);
        for (int b = 1; b < Block; ++b) {
            const auto better = sums[b][v] > maximum;
            maximum = better ? sums[b][v] : maximum;
            if constexpr (Record) which = better ? Vector<T>{} + static_cast<T>(field + b) : which;
        }
        if (field > 0) {
            const auto before = load<Vector<T>>(to);
            const auto better = maximum > before;
            maximum = better ? maximum : before;
            if constexpr (Record) {
                const auto bytes = load<Bytes>(best + v * kLanes);
                which = better ? which : __builtin_convertvector(bytes, Vector<T>);
            }
        }
        store(maximum * mask[v], to);
        if constexpr (Record) store(__builtin_convertvector(which, Bytes), best + v * kLanes);
    }
}

// A block of fields at a block of columns, in all rows.
template <class T, int Radius, int Order, int Block, bool Record>
void backup_block(const BackupShape& shape, View<const T> values, const T* filter, View<const T> rewards,
                  T* result, Index result_stride, std::uint8_t* best, int field, int column) {
    const Index outputs = static_cast<Index>(Order) * shape.fields;
    Vector<T> mask[kVectors];
    column_mask<T>(column, shape.width, mask);
    for (int row = 0; row < shape.height; ++row) {
        const T* const reward = rewards.origin + row * rewards.stride;
        Vector<T> sums[Block][kVectors];
        for (int b = 0; b < Block; ++b)
            for (int v = 0; v < kVectors; ++v)
                sums[b][v] = load<Vector<T>>(reward + b * rewards.plane + v * Lanes<T>::kCount);
        accumulate<T, Radius, Block>(sums, values.origin + row * values.stride, values.stride, values.plane,
                                     Order, filter, outputs);
        take_maximum<T, Block, Record>(sums, mask, field, result + row * result_stride,
                                       Record ? best + row * rewards.stride : nullptr);
    }
}

// The sums of rows that the products take: scratch[(pair * 4 + product) * order + channel], rows as those of
// values.
template <class T>
void sum_rows(const BackupShape& shape, View<const T> values, T* scratch) {
    constexpr int kLanes = Lanes<T>::kCount;
    const Index stride = values.stride, channels = shape.order;
    for (int row = 0; row < shape.height; row += 2)
        for (Index channel = 0; channel < channels; ++channel) {
            const T* const d0 = values.origin + channel * values.plane + (row - 1) * stride - 1;
            const T* const d3 = d0 + (row + 1 < shape.height ? 3 : 2) * stride;
            T* const to = scratch + (row / 2 * 4 * channels + channel) * stride;
            for (Index at = 0; at < stride; at += kLanes) {
                const Index x = at + kLanes <= stride ? at : stride - kLanes;
                const auto first = load<Vector<T>>(d0 + x), second = load<Vector<T>>(d0 + stride + x),
                           third = load<Vector<T>>(d0 + 2 * stride + x), fourth = load<Vector<T>>(d3 + x);
                store(first - third, to + x);
                store(second + third, to + channels * stride + x);
                store(third - second, to + 2 * channels * stride + x);
                store(second - fourth, to + 3 * channels * stride + x);
            }
        }
}

// sums += one product at one block of columns; as accumulate, of rows of three taps.
template <class T, int Order, int Block>
inline void accumulate_row(Vector<T> (&sums)[Block][kVectors], const T* rows, Index stride, const T* filter,
                           Index outputs) {
    for (int i = 0; i < Order; ++i, rows += stride)
        for (int x = 0; x < 3; ++x, filter += outputs) {
            Vector<T> values[kVectors];
            for (int v = 0; v < kVectors; ++v) values[v] = load<Vector<T>>(rows + x + v * Lanes<T>::kCount);
            for (int b = 0; b < Block; ++b)
                for (int v = 0; v < kVectors; ++v) sums[b][v] += values[v] * filter[b];
        }
}

template <class T, int Order, int Block, bool Record>
void backup_pair_block(const BackupShape& shape, const T* scratch, Index stride, const T* filter,
                       View<const T> rewards, T* result, Index result_stride, std::uint8_t* best, int field,
                       int column) {
    const Index outputs = static_cast<Index>(Order) * shape.fields;
    Vector<T> mask[kVectors];
    column_mask<T>(column, shape.width, mask);
    for (int row = 0; row < shape.height; row += 2) {
        Vector<T> upper[Block][kVectors], lower[Block][kVectors];
        const bool two = row + 1 < shape.height;
        for (int b = 0; b < Block; ++b)
            for (int v = 0; v < kVectors; ++v) {
                const T* const reward =
                    rewards.origin + row * rewards.stride + b * rewards.plane + v * Lanes<T>::kCount;
                upper[b][v] = load<Vector<T>>(reward);
                lower[b][v] = load<Vector<T>>(reward + (two ? rewards.stride : 0));
            }
        const auto product = [&](int k) {
            return [&, k](Vector<T>(&sums)[Block][kVectors]) {
                accumulate_row<T, Order, Block>(sums, scratch + (row / 2 * 4 + k) * Order * stride, stride,
                                                filter + k * 3 * Order * outputs, outputs);
            };
        };
        product(0)(upper);
        Vector<T> sums[Block][kVectors] = {};
        product(3)(sums);
        for (int b = 0; b < Block; ++b)
            for (int v = 0; v < kVectors; ++v) {
                lower[b][v] -= sums[b][v];
                sums[b][v] = Vector<T>{};
            }
        product(1)(sums);
        for (int b = 0; b < Block; ++b)
            for (int v = 0; v < kVectors; ++v) {
                upper[b][v] += sums[b][v];
                lower[b][v] += sums[b][v];
                sums[b][v] = Vector<T>{};
            }
        product(2)(sums);
        for (int b = 0; b < Block; ++b)
            for (int v = 0; v < kVectors; ++v) {
                upper[b][v] += sums[b][v];
                lower[b][v] -= sums[b][v];
            }
        std::uint8_t* const where = Record ? best + row * rewards.stride : nullptr;
        take_maximum<T, Block, Record>(upper, mask, field, result + row * result_stride, where);
        if (two)
            take_maximum<T, Block, Record>(lower, mask, field, result + (row + 1) * result_stride,
                                           Record ? where + rewards.stride : nullptr);
    }
}

template <class T, int Order, bool Record>
void backup_pair_order(const BackupShape& shape, Index stride, const T* filter, View<const T> rewards,
                       View<T> result, std::uint8_t* best, const T* scratch) {
    for (int h = 0; h < Order; ++h)
        for (int column = 0; column < shape.width; column += Lanes<T>::kColumns)
            for_blocks(shape.fields, [&]<int Block>(int field) {
                const Index channel = h * shape.fields + field;
                backup_pair_block<T, Order, Block, Record>(
                    shape, scratch + column, stride, filter + channel,
                    {rewards.origin + channel * rewards.plane + column, rewards.stride, rewards.plane},
                    result.origin + h * result.plane + column, result.stride,
                    Record ? best + h * rewards.plane + column : nullptr, field, column);
            });
}

template <class T, bool Record>
void backup_pair_record(const BackupShape& shape, Index stride, const T* filter, View<const T> rewards,
                        View<T> result, std::uint8_t* best, const T* scratch) {
    switch (shape.order) {
        case 1:
            return backup_pair_order<T, 1, Record>(shape, stride, filter, rewards, result, best, scratch);
        case 4:
            return backup_pair_order<T, 4, Record>(shape, stride, filter, rewards, result, best, scratch);
        default:
            return backup_pair_order<T, 8, Record>(shape, stride, filter, rewards, result, best, scratch);
    }
}

template <class T>
void backup_by_pairs(const BackupShape& shape, View<const T> values, const T* filter, View<const T> rewards,
                     View<T> result, std::uint8_t* best, T* scratch) {
    sum_rows<T>(shape, values, scratch);
    best ? backup_pair_record<T, true>(shape, values.stride, filter, rewards, result, best, scratch)
         : backup_pair_record<T, false>(shape, values.stride, filter, rewards, result, best, scratch);
}

template <class T, int Radius, int Order, bool Record>
void backup_order(const BackupShape& shape, View<const T> values, const T* filter, View<const T> rewards,
                  View<T> result, std::uint8_t* best) {
    for (int h = 0; h < Order; ++h)
        for (int column = 0; column < shape.width; column += Lanes<T>::kColumns)
            for_blocks(shape.fields, [&]<int Block>(int field) {
                const Index channel = h * shape.fields + field;
                backup_block<T, Radius, Order, Block, Record>(
                    shape, {values.origin + column, values.stride, values.plane}, filter + channel,
                    {rewards.origin + channel * rewards.plane + column, rewards.stride, rewards.plane},
                    result.origin + h * result.plane + column, result.stride,
                    Record ? best + h * rewards.plane + column : nullptr, field, column);
            });
}

template <class T, int Radius, bool Record>
void backup_radius(const BackupShape& shape, View<const T> values, const T* filter, View<const T> rewards,
                   View<T> result, std::uint8_t* best) {
    switch (shape.order) {
        case 1:
            return backup_order<T, Radius, 1, Record>(shape, values, filter, rewards, result, best);
        case 4:
            return backup_order<T, Radius, 4, Record>(shape, values, filter, rewards, result, best);
        default:
            return backup_order<T, Radius, 8, Record>(shape, values, filter, rewards, result, best);
    }
}

template <class T>
void backup(const BackupShape& shape, View<const T> values, const T* filter, View<const T> rewards,
            View<T> result, std::uint8_t* best) {
    if (shape.radius == 1)
        best ? backup_radius<T, 1, true>(shape, values, filter, rewards, result, best)
             : backup_radius<T, 1, false>(shape, values, filter, rewards, result, best);
    else
        best ? backup_radius<T, 2, true>(shape, values, filter, rewards, result, best)
             : backup_radius<T, 2, false>(shape, values, filter, rewards, result, best);
}

template <class T, int Order>
struct Cell {
    typedef T Vector __attribute__((vector_size(Order * sizeof(T))));
};
template <class T>
struct Cell<T, 1> {
    typedef T Vector;
};

template <class T, int Order, int Radius>
void backup_gradient_order(const BackupShape& shape, View<const T> values, const T* turned,
                           const std::uint8_t* best, View<const T> of_result, View<T> of_values, T* of_turned,
                           View<T> of_rewards) {
    using V = typename Cell<T, Order>::Vector;
    constexpr int kSide = 2 * Radius + 1;
    constexpr int kTaps = kSide * kSide;
    const Index stride = values.stride;
    for (int row = 0; row < shape.height; ++row)
        for (int column = 0; column < shape.width; ++column) {
            const Index corner = (row - Radius) * stride + column - Radius;
            const Index cell = row * of_rewards.stride + column;
            const T* const gradients = of_result.origin + (row * of_result.stride + column) * Order;
            for (int h = 0; h < Order; ++h) {
                const T g = gradients[h];
                if (g == 0) continue;
                const Index output = h * shape.fields + best[h * of_rewards.plane + cell];
                const T* const weights = turned + output * kTaps * Order;
                T* const of_weights = of_turned ? of_turned + output * kTaps * Order : nullptr;
                if (of_rewards.origin) of_rewards.origin[output * of_rewards.plane + cell] += g;
                for (int y = 0; y < kSide; ++y)
                    for (int x = 0; x < kSide; ++x) {
                        const Index at = (corner + y * stride + x) * Order;
                        const int tap = (y * kSide + x) * Order;
                        store(load<V>(of_values.origin + at) + load<V>(weights + tap) * g,
                              of_values.origin + at);
                    }
                if (!of_weights) continue;
                for (int y = 0; y < kSide; ++y)
                    for (int x = 0; x < kSide; ++x) {
                        const int tap = (y * kSide + x) * Order;
                        store(load<V>(of_weights + tap) +
                                  load<V>(values.origin + (corner + y * stride + x) * Order) * g,
                              of_weights + tap);
                    }
            }
        }
}

template <class T, int Radius>
void backup_gradient_radius(const BackupShape& shape, View<const T> values, const T* turned,
                            const std::uint8_t* best, View<const T> of_result, View<T> of_values,
                            T* of_turned, View<T> of_rewards) {
    const auto run = [&]<int Order>() {
        backup_gradient_order<T, Order, Radius>(shape, values, turned, best, of_result, of_values, of_turned,
                                                of_rewards);
    };
    switch (shape.order) {
        case 1:
            return run.template operator()<1>();
        case 4:
            return run.template operator()<4>();
        default:
            return run.template operator()<8>();
    }
}

template <class T>
void backup_gradient(const BackupShape& shape, View<const T> values, const T* turned,
                     const std::uint8_t* best, View<const T> of_result, View<T> of_values, T* of_turned,
                     View<T> of_rewards) {
    shape.radius == 1 ? backup_gradient_radius<T, 1>(shape, values, turned, best, of_result, of_values,
                                                     of_turned, of_rewards)
                      : backup_gradient_radius<T, 2>(shape, values, turned, best, of_result, of_values,
                                                     of_turned, of_rewards);
}

// exp(x) by 2^n (1 + ...), relative error below 2e-7, for floats that vectorise; exact to rounding for
// doubles.
inline float exponential(float x) {
    x = x < -87.0f ? -87.0f : x;
    x = x > 88.0f ? 88.0f : x;
    const float scaled = x * 1.44269504f;
    const int n = static_cast<int>(scaled + (scaled < 0 ? -0.5f : 0.5f));
    const float r = (x - static_cast<float>(n) * 0.693359375f) + static_cast<float>(n) * 2.12194440e-4f;
    float p = 1.9875691500e-4f;
    p = p * r + 1.3981999507e-3f;
    p = p * r + 8.3334519073e-3f;
    p = p * r + 4.1665795894e-2f;
    p = p * r + 1.6666665459e-1f;
    p = p * r + 5.0000001201e-1f;
    p = p * r * r + r + 1.0f;
    const int bits = (n + 127) << 23;
    float power;
    __builtin_memcpy(&power, &bits, sizeof(power));
    return p * power;
}
inline double exponential(double x) {
    return __builtin_exp(x);
}

template <class T>
void sigmoid(T* x, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) x[i] = 1 / (1 + exponential(-x[i]));
}

template <class T>
void tanh(T* x, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) x[i] = 1 - 2 / (1 + exponential(2 * x[i]));
}

}  // namespace

template <class T>
const Kernels<T>& table() {
    static constexpr char kText[] = PRAXIS_KERNELS_TEXT;
    static constexpr Kernels<T> kTable{
        kText,      convolve<T>, convolve_gradient<T>, backup<T>, backup_by_pairs<T>, backup_gradient<T>,
        sigmoid<T>, tanh<T>};
    return kTable;
}

template const Kernels<float>& table<float>();
template const Kernels<double>& table<double>();

}  // namespace praxis::learned::PRAXIS_KERNELS
