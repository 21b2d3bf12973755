#include "practice/experiment/axis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "practice/experiment/number_text.hpp"

namespace praxis::practice {
namespace {

struct Unit {
    double size;
    const char* sign;
};

Unit unit_for(double largest) {
    constexpr Unit kUnits[] = {{1e12, "T"}, {1e9, "G"}, {1e6, "M"}, {1e3, "k"}};
    if (largest >= 1e5)
        for (const Unit& unit : kUnits)
            if (largest >= unit.size) return unit;
    return {1, ""};
}

/// How many digits behind the point tell multiples of `step` apart.
int digits_for(double step) {
    return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 12);
}

}  // namespace

std::vector<Tick> round_ticks(double low, double high, int wanted) {
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high) || wanted < 2)
        throw std::invalid_argument("an axis needs two finite ends, the lower one first");
    const double raw = (high - low) / (wanted - 1);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= raw * (1 - 1e-9)) step = factor * power;
    const Unit unit = unit_for(std::max(std::abs(low), std::abs(high)));
    const int digits = digits_for(step / unit.size);
    std::vector<Tick> ticks;
    const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
    for (double i = first; i <= last; ++i) {
        const double value = i * step;
        ticks.push_back({value, digits == 0 ? grouped(value / unit.size) + unit.sign
                                            : fixed(value / unit.size, digits) + unit.sign});
    }
    return ticks;
}

}  // namespace praxis::practice
