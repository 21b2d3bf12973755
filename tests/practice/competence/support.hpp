// Simulated learners, whose competences are known.
#pragma once

#include <cmath>
#include <numbers>

#include "practice/competence/competence_model.hpp"
#include "practice/environment.hpp"

namespace praxis::practice {

inline void observe(CompetenceModel& model, int successes, int failures) {
    for (int i = 0; i < successes; ++i) model.observe(true);
    for (int i = 0; i < failures; ++i) model.observe(false);
}

inline void cycle(CompetenceModel& model, int successes, int failures) {
    observe(model, successes, failures);
    model.advance_cycle();
}

/// A competence that grows exponentially with the outcomes learned from.
struct Learner {
    double first, last, constant;  ///< `constant`: outcomes until 63 % of the growth
    double competence(double outcomes) const {
        return first + (last - first) * (1 - std::exp(-outcomes / constant));
    }
};

/// Marsaglia and Tsang, 2000; shape positive.
inline double sample_gamma(double shape, Random& random) {
    if (shape < 1) return sample_gamma(shape + 1, random) * std::pow(1 - uniform(random), 1 / shape);
    const double d = shape - 1.0 / 3, c = 1 / std::sqrt(9 * d);
    while (true) {
        const double radius = std::sqrt(-2 * std::log(1 - uniform(random)));
        const double x = radius * std::cos(2 * std::numbers::pi * uniform(random));
        const double v = std::pow(1 + c * x, 3);
        if (v > 0 && std::log(1 - uniform(random)) < x * x / 2 + d - d * v + d * std::log(v)) return d * v;
    }
}

inline double sample(const Beta& beta, Random& random) {
    const double successes = sample_gamma(beta.successes, random);
    return successes / (successes + sample_gamma(beta.failures, random));
}

}  // namespace praxis::practice
