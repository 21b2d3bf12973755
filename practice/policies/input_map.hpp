// What a classifier is fed with: the numbers of a row, standardised, and if wanted their pairwise
// differences.
//
// Success often depends on where two things are to each other, and the difference of two positions is small
// against the positions themselves: standardised on its own it is what a network finds at once, and finds
// late otherwise (bench/policy_bench.cpp measures it). Numbers that never vary are left out (but one input
// remains, always 0, where none varies).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "practice/policies/classifier.hpp"
#include "practice/policies/standardisation.hpp"

namespace praxis::practice {

class InputMap {
  public:
    InputMap() = default;
    /// Learns what is usual from the examples. Throws std::invalid_argument with the place of a number that
    /// is not finite, or for lists whose lengths do not fit.
    InputMap(const Examples& examples, bool differences);

    std::size_t width() const { return width_; }  ///< of a row
    std::size_t size() const { return terms_.size(); }
    /// Writes `size()` inputs for each row.
    void apply(std::span<const float> rows, std::span<float> inputs) const;

  private:
    static constexpr std::size_t kNothing = static_cast<std::size_t>(-1);
    struct Term {
        std::size_t plus, minus;  // columns; minus may be kNothing
        Standardisation standard;
    };

    std::size_t width_ = 0;
    std::vector<Term> terms_;
};

}  // namespace praxis::practice
