// A column of numbers moved and scaled to mean 0 and variance 1.
#pragma once

#include <cmath>
#include <cstddef>

namespace praxis::practice {

struct Standardisation {
    double mean = 0;
    double scale = 0;  ///< one by the standard deviation; 0: the column does not vary
    float operator()(double value) const { return static_cast<float>((value - mean) * scale); }
};

/// Of the numbers value(0), ..., value(count - 1). A column that varies less than rounding does against
/// `magnitude` counts as constant.
template <class Value>
Standardisation standardisation(std::size_t count, double magnitude, Value value) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += value(i);
    const double mean = count == 0 ? 0 : sum / static_cast<double>(count);
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) squares += (value(i) - mean) * (value(i) - mean);
    const double deviation = count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
    constexpr double kRounding = 1e-5;
    return {mean, deviation > kRounding * magnitude ? 1 / deviation : 0};
}

}  // namespace praxis::practice
