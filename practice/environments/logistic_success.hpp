// How likely a simulated skill succeeds, stated as a formula.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace praxis::practice {

/// ceiling / (1 + exp((distance - tolerance) / width)): nearly `ceiling` well within the tolerance, half of
/// it at the tolerance, nearly 0 well beyond.
struct LogisticSuccess {
    double tolerance = 0;  ///< in the units of the distance
    double width = 0.05;
    double ceiling = 0.97;
    double probability(double distance) const {
        return ceiling / (1 + std::exp((distance - tolerance) / width));
    }
};

inline double euclidean_distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

}  // namespace praxis::practice
