#include "practice/experiment/time_left.hpp"

#include <algorithm>
#include <limits>

namespace praxis::practice {

TimeLeft::TimeLeft(std::vector<double> cycles) {
    for (const double left : cycles) cells_.push_back({left, 0, 0});
}

void TimeLeft::observe(std::size_t cell, double cycles, double seconds) {
    skip(cell, cycles);
    cells_[cell].done += cycles;
    cells_[cell].seconds += seconds;
}

void TimeLeft::skip(std::size_t cell, double cycles) {
    cells_[cell].left = std::max(0.0, cells_[cell].left - cycles);
}

double TimeLeft::fraction_done() const {
    double left = 0, done = 0;
    for (const Cell& cell : cells_) {
        left += cell.left;
        done += cell.done;
    }
    return left > 0 ? done / (done + left) : 1;
}

double TimeLeft::seconds(std::size_t threads) const {
    double rates = 0, known = 0;
    for (const Cell& cell : cells_) {
        if (cell.done <= 0) continue;
        rates += cell.seconds / cell.done;
        ++known;
    }
    double seconds = 0;
    for (const Cell& cell : cells_) {
        if (cell.left <= 0) continue;
        if (known == 0) return std::numeric_limits<double>::infinity();
        seconds += cell.left * (cell.done > 0 ? cell.seconds / cell.done : rates / known);
    }
    return seconds / static_cast<double>(std::max<std::size_t>(threads, 1));
}

}  // namespace praxis::practice
