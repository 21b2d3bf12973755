// Low-discrepancy samples of the configurations of a group.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis::tamp {

/// An interval of a variable.
struct Interval {
    double lower = 0;
    double upper = 0;
};

/// The additive sequence whose steps are the powers of the generalised golden ratio (M. Roberts, 2018):
/// evenly spread in every dimension for the cost of one addition a number. The seed shifts it.
class Sampler {
  public:
    static constexpr std::size_t kMaxDimension = 16;

    Sampler(std::span<const Interval> ranges, std::uint64_t seed) : dimension_(ranges.size()) {
        double ratio = 2;  // the root above 1 of x^(d+1) = x + 1
        for (int i = 0; i < 40; ++i) ratio = std::pow(1 + ratio, 1.0 / (static_cast<double>(dimension_) + 1));
        Random random(seed);
        double step = 1;
        for (std::size_t v = 0; v < dimension_; ++v) {
            step /= ratio;
            steps_[v] = step;
            places_[v] = static_cast<double>(random.next() >> 11) * 0x1p-53;
            lower_[v] = ranges[v].lower;
            width_[v] = ranges[v].upper - ranges[v].lower;
        }
    }

    void next(double* positions) {
        for (std::size_t v = 0; v < dimension_; ++v) {
            const double place = places_[v] + steps_[v];
            places_[v] = place - static_cast<double>(place >= 1);
            positions[v] = lower_[v] + places_[v] * width_[v];
        }
    }

  private:
    std::size_t dimension_;
    std::array<double, kMaxDimension> steps_ = {};
    std::array<double, kMaxDimension> places_ = {};
    std::array<double, kMaxDimension> lower_ = {};
    std::array<double, kMaxDimension> width_ = {};
};

}  // namespace praxis::tamp
