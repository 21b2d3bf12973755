// The Beta distribution, what is known of a probability.
#pragma once

#include "practice/competence/counts.hpp"

namespace praxis::practice {

/// Both counts positive; they are outcomes as good as seen.
struct Beta {
    double successes = 1, failures = 1;

    double strength() const { return successes + failures; }
    double mean() const { return successes / strength(); }
    double variance() const {
        const double n = strength();
        return successes * failures / (n * n * (n + 1));
    }
    /// What is known after more outcomes.
    Beta after(const Counts& counts) const {
        return {successes + static_cast<double>(counts.successes),
                failures + static_cast<double>(counts.failures)};
    }
    friend bool operator==(const Beta&, const Beta&) = default;
};

/// Throws std::invalid_argument unless both counts are positive and finite.
void check(const Beta& beta);

}  // namespace praxis::practice
