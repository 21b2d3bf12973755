#include "practice/policies/adam.hpp"

#include <cmath>

namespace praxis::practice {

void Adam::step(std::span<float> weights, std::span<const float> gradient, float rate, float decay) {
    constexpr float kMean = 0.9f;
    constexpr float kSquare = 0.999f;
    constexpr float kEpsilon = 1e-8f;
    mean_factor_ *= kMean;
    square_factor_ *= kSquare;
    const float unbiased = rate / static_cast<float>(1 - mean_factor_);
    const float scale = 1 / std::sqrt(static_cast<float>(1 - square_factor_));
    const float keep = 1 - rate * decay;
    float* const w = weights.data();
    const float* const g = gradient.data();
    float* const m = mean_.data();
    float* const s = square_.data();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        m[i] = kMean * m[i] + (1 - kMean) * g[i];
        s[i] = kSquare * s[i] + (1 - kSquare) * g[i] * g[i];
        w[i] = keep * w[i] - unbiased * m[i] / (std::sqrt(s[i]) * scale + kEpsilon);
    }
}

}  // namespace praxis::practice
