#include "learned/groups/shared_filter.hpp"

#include <cmath>

namespace praxis::learned {
namespace {

// The orbit of each triple (input channel, tap, output channel) of a pair of fields, and their number.
struct Orbits {
    std::vector<int> of;
    int count = 0;
};

Orbits orbits(const Group& group, const Representation& input, const Representation& output, int radius) {
    const int side = 2 * radius + 1, taps = side * side;
    const auto index = [&](int k, int t, int l) {
        return static_cast<std::size_t>((k * taps + t) * output.size + l);
    };
    const auto turned = [&](int g, int t) {
        const Offset offset = group.apply(g, {t / side - radius, t % side - radius});
        return (offset.row + radius) * side + offset.column + radius;
    };
    Orbits result{std::vector<int>(index(input.size, 0, 0), -1), 0};
    for (int k = 0; k < input.size; ++k)
        for (int t = 0; t < taps; ++t)
            for (int l = 0; l < output.size; ++l) {
                if (result.of[index(k, t, l)] >= 0) continue;
                for (int g = 0; g < group.order(); ++g)
                    result.of[index(input(g, k), turned(g, t), output(g, l))] = result.count;
                ++result.count;
            }
    return result;
}

// Scaled weights stay within the bound after rounding, so that scaling again changes nothing.
constexpr double kMargin = 5e-7;

}  // namespace

SharedFilter::SharedFilter(const Group& group, const Fields& input, const Fields& output, int radius)
    : inputs_(input.channels()),
      outputs_(output.channels()),
      radius_(radius),
      input_fields_(input.count),
      output_fields_(output.count) {
    const Orbits pair = orbits(group, input.representation, output.representation, radius);
    orbits_ = pair.count;
    parameters_ = static_cast<std::size_t>(output_fields_ * input_fields_ * orbits_);
    parameter_of_.resize(static_cast<std::size_t>(inputs_ * taps() * outputs_));
    for (int i = 0; i < inputs_; ++i)
        for (int t = 0; t < taps(); ++t)
            for (int o = 0; o < outputs_; ++o) {
                const int k = i / input_fields_, l = o / output_fields_;
                const int orbit =
                    pair.of[static_cast<std::size_t>((k * taps() + t) * output.representation.size + l)];
                parameter_of_[static_cast<std::size_t>((i * taps() + t) * outputs_ + o)] =
                    static_cast<std::uint32_t>(
                        (o % output_fields_ * input_fields_ + i % input_fields_) * orbits_ + orbit);
            }
}

template <class T>
void SharedFilter::bound_norm(std::span<T> parameters, T bound) const {
    const std::size_t of_field = static_cast<std::size_t>(input_fields_ * orbits_);
    for (int field = 0; field < output_fields_; ++field) {
        double norm = 0;
        for (int tap = 0; tap < inputs_ * taps(); ++tap)
            norm += static_cast<double>(
                std::abs(parameters[parameter_of_[static_cast<std::size_t>(tap * outputs_ + field)]]));
        if (!(norm > static_cast<double>(bound))) continue;
        const T factor = static_cast<T>((1 - kMargin) * static_cast<double>(bound) / norm);
        for (T& weight : parameters.subspan(static_cast<std::size_t>(field) * of_field, of_field))
            weight *= factor;
    }
}

template void SharedFilter::bound_norm(std::span<float>, float) const;
template void SharedFilter::bound_norm(std::span<double>, double) const;

}  // namespace praxis::learned
