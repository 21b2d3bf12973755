#include "app/belief_worlds.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace praxis::app {
namespace {

/// More first states than these are not counted.
constexpr std::size_t kMostEnumerated = 5'000;

[[noreturn]] void none() {
    throw std::invalid_argument("no first state satisfies the initial description");
}

}  // namespace

BeliefWorlds::BeliefWorlds(const belief::BeliefTask& task, const BeliefOptions& options)
    : task_(task),
      drawn_(options.samples || task.worlds.size() == 0),
      count_(drawn_ ? options.samples.value_or(options.runs.value_or(1))
                    : std::min(task.worlds.size(), options.runs.value_or(task.worlds.size()))),
      random_(options.seed) {
    if (!drawn_) return;
    all_ = belief::enumerate_worlds(task, kMostEnumerated);
    if (all_ && all_->empty()) none();
}

belief::WorldState BeliefWorlds::next(std::size_t i) {
    if (!drawn_) return belief::hidden_world(task_, i * task_.worlds.size() / count_);
    if (all_) return (*all_)[random_.below(all_->size())];
    std::optional<belief::WorldState> world = belief::sample_world(task_, random_);
    if (!world) none();
    return std::move(*world);
}

}  // namespace praxis::app
