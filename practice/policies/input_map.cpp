#include "practice/policies/input_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace praxis::practice {

namespace {

/// Standard deviations that a row may be away: keeps odd rows from overflowing.
constexpr float kFarthest = 100;

void check(const Examples& examples) {
    if (examples.width == 0) throw std::invalid_argument("examples need at least one number a row");
    if (examples.rows.size() != examples.size() * examples.width)
        throw std::invalid_argument("examples: " + std::to_string(examples.size()) + " outcomes of width " +
                                    std::to_string(examples.width) + " do not fit " +
                                    std::to_string(examples.rows.size()) + " numbers");
    for (std::size_t i = 0; i < examples.rows.size(); ++i)
        if (!std::isfinite(examples.rows[i]))
            throw std::invalid_argument("example " + std::to_string(i / examples.width) + ": number " +
                                        std::to_string(i % examples.width) + " is not finite");
}

double magnitude(const Examples& examples, std::size_t column) {
    double largest = 0;
    for (std::size_t r = 0; r < examples.size(); ++r)
        largest = std::max(largest, std::abs(double{examples.rows[r * examples.width + column]}));
    return largest;
}

}  // namespace

InputMap::InputMap(const Examples& examples, bool differences) : width_(examples.width) {
    check(examples);
    const auto at = [&](std::size_t row, std::size_t column) -> double {
        return examples.rows[row * width_ + column];
    };
    std::vector<double> magnitudes;
    for (std::size_t i = 0; i < width_; ++i) {
        magnitudes.push_back(magnitude(examples, i));
        const Standardisation standard =
            standardisation(examples.size(), magnitudes[i], [&](std::size_t row) { return at(row, i); });
        if (standard.scale > 0) terms_.push_back({i, kNothing, standard});
    }
    if (terms_.empty()) terms_.push_back({0, kNothing, {}});
    if (!differences) return;
    const std::vector<Term> varying = terms_;
    for (const Term& a : varying)
        for (const Term& b : varying) {
            if (b.plus >= a.plus) break;
            const Standardisation standard =
                standardisation(examples.size(), std::max(magnitudes[a.plus], magnitudes[b.plus]),
                                [&](std::size_t row) { return at(row, a.plus) - at(row, b.plus); });
            if (standard.scale > 0) terms_.push_back({a.plus, b.plus, standard});
        }
}

void InputMap::apply(std::span<const float> rows, std::span<float> inputs) const {
    float* next = inputs.data();
    for (std::size_t first = 0; first < rows.size(); first += width_)
        for (const Term& term : terms_) {
            const double plus = rows[first + term.plus];
            const double minus = term.minus == kNothing ? 0.0 : double{rows[first + term.minus]};
            *next++ = std::clamp(term.standard(plus - minus), -kFarthest, kFarthest);
        }
}

}  // namespace praxis::practice
