// Ticks of a chart's axis at round numbers.
#pragma once

#include <string>
#include <vector>

namespace praxis::practice {

struct Tick {
    double value = 0;
    std::string label;
};

/// Multiples of 1, 2 or 5 times a power of ten from `low` to `high`, about `wanted` of them (at least 2);
/// labels as "2,500", or from a hundred thousand on as "0.5M". Throws std::invalid_argument unless both ends
/// are finite and low < high.
std::vector<Tick> round_ticks(double low, double high, int wanted);

}  // namespace praxis::practice
