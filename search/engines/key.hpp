// What open lists sort by: numbers made of g and of heuristics' estimates.
//
// The heuristics of a search are numbered, each evaluated once a state. A key is a linear form in g and the
// estimates, plus weighted maxima of such forms; everything that g(), sum, weight, max and const can say.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "search/evaluators/evaluator.hpp"

namespace praxis {

/// The key of states from which some heuristic of the key sees no way to the goal.
inline constexpr std::int64_t kInfiniteKey = std::numeric_limits<std::int64_t>::max();

/// Which lists are to file an entry: those that take every state, those that take states reached by preferred
/// operators alone, or both.
enum class Audience : std::uint8_t { lists_of_all, lists_of_preferred, all_lists };

/// What is known about a state, or about the parent that stands for it in a deferred evaluation.
struct Evaluated {
    std::span<const Estimate> estimates;  ///< by heuristic
    std::int64_t g = 0;
    Audience audience = Audience::lists_of_all;
};

class Key {
  public:
    static Key heuristic(std::size_t number);
    static Key cost_so_far();
    static Key constant(std::int64_t value);
    static Key sum(const std::vector<Key>& parts);
    static Key maximum(std::vector<Key> parts);
    static Key weighted(Key part, std::int64_t weight);

    /// kInfiniteKey if an estimate that it needs is kDeadEnd. Values beyond 64 bits stop just below that.
    std::int64_t value(const Evaluated& state) const;
    bool uses_g() const;
    /// Adds the numbers of the heuristics it needs.
    void collect_heuristics(std::vector<std::size_t>& numbers) const;
    /// Never more than the cost of a way to the goal, given which heuristics are so.
    bool admissible(const std::vector<bool>& heuristic_admissible) const;

  private:
    struct Term {
        std::size_t heuristic;
        std::int64_t weight;
    };
    struct Maximum {
        std::vector<Key> parts;
        std::int64_t weight;
    };
    std::int64_t constant_ = 0;
    std::int64_t g_weight_ = 0;
    std::vector<Term> terms_;
    std::vector<Maximum> maxima_;
};

}  // namespace praxis
