// Where descents of inverse kinematics start: configurations spread evenly within the limits, with the poses
// that they reach, so that those near a target can be tried first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tamp/motion/ik_descent.hpp"

namespace praxis::tamp {

/// A low-discrepancy sequence (Roberts 2018: multiples of the powers of a generalised golden ratio) in the
/// unit cube: number `index`, coordinate by coordinate.
class EvenSequence {
  public:
    explicit EvenSequence(std::size_t dimension);
    double operator()(std::uint64_t index, std::size_t coordinate) const;

  private:
    Columns steps_ = {};
};

class IkStarts {
  public:
    static constexpr std::size_t kCount = 1024;

    /// All within the limits; a slide without limits stays within a metre of `rest`, whose values the
    /// columns that move nothing take.
    IkStarts(const KinematicChain& chain, const Columns& lower, const Columns& upper, const Columns& rest);

    const Columns& operator[](std::size_t index) const { return positions_[index]; }

    /// Hands out all starts for a target, the nearest first.
    class Order {
      public:
        /// Seeds other than 0 shuffle the order: distances count up to four times as much.
        Order(const IkStarts& starts, const IkDescent& problem, std::uint64_t seed);
        /// Number of the next start; kCount after the last.
        std::size_t next();

      private:
        std::array<float, kCount> distance_;
    };

  private:
    std::vector<Columns> positions_;
    /// Of the tool at each start: x, y, z of the origin, then of its x axis, then of its z axis.
    std::array<std::vector<float>, 9> reached_;
};

}  // namespace praxis::tamp
