// How long an experiment still takes, from the cycles that its runs have gone through.
//
// A *cell* is one method in one environment; the cycles of its runs take about the same time. Cells of which
// nothing is known yet are expected to be as slow as the mean of the others.
#pragma once

#include <cstddef>
#include <vector>

namespace praxis::practice {

class TimeLeft {
  public:
    /// `cycles`: by cell, those that are still to be done, those of all its runs together.
    explicit TimeLeft(std::vector<double> cycles);

    /// Some cycles of a cell have taken so many seconds.
    void observe(std::size_t cell, double cycles, double seconds);
    /// Cycles of a run that ended early will never be done.
    void skip(std::size_t cell, double cycles);

    /// Of all cycles, in [0, 1].
    double fraction_done() const;
    /// Wall seconds with so many runs at a time; infinite before the first cycle.
    double seconds(std::size_t threads) const;

  private:
    struct Cell {
        double left = 0, done = 0, seconds = 0;
    };
    std::vector<Cell> cells_;
};

}  // namespace praxis::practice
