#include "practice/competence/optimistic_model.hpp"

#include <algorithm>
#include <span>

namespace praxis::practice {
namespace {

std::span<const Counts> last(const std::vector<Counts>& cycles, std::size_t count) {
    return std::span(cycles).last(std::min(count, cycles.size()));
}

}  // namespace

OptimisticModel::OptimisticModel(Beta prior, int window, int recency, double bonus)
    : prior_(prior),
      window_(static_cast<std::size_t>(window)),
      recency_(static_cast<std::size_t>(recency)),
      bonus_(bonus) {}

void OptimisticModel::observe(bool success) {
    if (!cycle_open_) {
        if (cycles_.size() == std::max({window_, recency_, std::size_t{2}})) cycles_.erase(cycles_.begin());
        cycles_.emplace_back();
        cycle_open_ = true;
    }
    cycles_.back().add(success);
}

void OptimisticModel::set_prior(Beta prior) {
    check(prior);
    prior_ = prior;
}

Counts OptimisticModel::evidence() const {
    Counts sum;
    for (const Counts& cycle : last(cycles_, window_)) sum += cycle;
    return sum;
}

double OptimisticModel::predict(int /*outcomes*/, int cycles) const {
    if (cycles_.size() < 2) return clip(competence() + bonus_);
    double lowest = 1, highest = 0;
    for (const Counts& cycle : last(cycles_, recency_)) {
        const double success = static_cast<double>(cycle.successes) / static_cast<double>(cycle.total());
        lowest = std::min(lowest, success);
        highest = std::max(highest, success);
    }
    return clip(competence() + (highest - lowest) * cycles);
}

}  // namespace praxis::practice
