#include "search/landmarks/landmark_status.hpp"

#include <algorithm>

namespace praxis {

LandmarkStatus::LandmarkStatus(const LandmarkGraph& graph)
    : graph_(graph),
      stride_(graph.size() / 64 + 1),
      may_return_(words(), 0),
      scratch_(words()),
      parent_past_(words()) {
    for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
        for (const LandmarkGraph::Neighbour next : graph.successors[landmark]) {
            if (next.ordering == LandmarkOrdering::greedy_necessary) enabled_.add(next.landmark);
        }
        enabled_.close();
        if (graph.goal[landmark] || !enabled_[landmark].empty() || !graph.undone_by[landmark].empty())
            add_landmark(may_return_, landmark);
    }
}

LandmarkWord* LandmarkStatus::find(StateId state) const {
    const std::size_t block = state.index() >> kBlockShift;
    if (block >= blocks_.size() || !blocks_[block]) return nullptr;
    return blocks_[block].get() + (state.index() & kBlockMask) * stride_;
}

LandmarkWord* LandmarkStatus::find_or_make(StateId state) {
    const std::size_t block = state.index() >> kBlockShift;
    if (block >= blocks_.size()) blocks_.resize(block + 1);
    if (!blocks_[block]) blocks_[block] = std::make_unique<LandmarkWord[]>(stride_ << kBlockShift);
    return find(state);
}

bool LandmarkStatus::known(StateId state) const {
    const LandmarkWord* const record = find(state);
    return record != nullptr && has_landmark({record, stride_}, graph_.size());
}

void LandmarkStatus::past(StateId state, std::span<LandmarkWord> past) const {
    const LandmarkWord* const record = find(state);
    std::copy_n(record, words(), past.begin());
    // The mark of known states.
    if (graph_.size() % 64 != 0) past.back() &= (LandmarkWord{1} << (graph_.size() % 64)) - 1;
}

/// Adds the landmarks that hold and whose predecessors are in `before`, for derived ones in `past` itself.
void LandmarkStatus::reach(StateView state, LandmarkBits before, std::span<LandmarkWord> past) const {
    for (std::size_t word = 0; word < past.size(); ++word) {
        const std::size_t left = std::min<std::size_t>(graph_.size() - word * 64, 64);
        const LandmarkWord all = left == 64 ? ~LandmarkWord{0} : (LandmarkWord{1} << left) - 1;
        for_each_landmark(all & ~past[word], word, [&](std::size_t landmark) {
            if (graph_.holds(landmark, state) && leaf(landmark, graph_.derived[landmark] ? past : before)) {
                add_landmark(past, landmark);
            }
        });
    }
}

bool LandmarkStatus::leaf(std::size_t landmark, LandmarkBits past) const {
    for (const LandmarkGraph::Neighbour before : graph_.predecessors[landmark]) {
        if (!has_landmark(past, before.landmark)) return false;
    }
    return true;
}

void LandmarkStatus::initial_past(StateView state, std::span<LandmarkWord> past) const {
    std::ranges::fill(past, LandmarkWord{0});
    reach(state, past, past);
}

void LandmarkStatus::start(StateId initial, StateView state) {
    blocks_.clear();
    initial_past(state, scratch_);
    LandmarkWord* const record = find_or_make(initial);
    std::ranges::copy(scratch_, record);
    add_landmark({record, stride_}, graph_.size());
}

void LandmarkStatus::follow(StateId parent, StateId child, StateView child_state) {
    if (parent == child || !known(parent)) return;
    past(parent, parent_past_);
    scratch_ = parent_past_;
    reach(child_state, parent_past_, scratch_);
    const bool seen = known(child);
    LandmarkWord* const record = find_or_make(child);
    if (seen) {
        for (std::size_t word = 0; word < scratch_.size(); ++word) scratch_[word] &= record[word];
    }
    std::ranges::copy(scratch_, record);
    add_landmark({record, stride_}, graph_.size());
}

void LandmarkStatus::required_again(StateView state, LandmarkBits past,
                                    std::span<LandmarkWord> required) const {
    for (std::size_t word = 0; word < required.size(); ++word) {
        required[word] = 0;
        for_each_landmark(past[word] & may_return_[word], word, [&](std::size_t landmark) {
            const auto missing = [&](std::uint32_t other) { return !has_landmark(past, other); };
            if (std::ranges::any_of(graph_.undone_by[landmark], missing) ||
                (!graph_.holds(landmark, state) &&
                 (graph_.goal[landmark] || std::ranges::any_of(enabled_[landmark], missing)))) {
                add_landmark(required, landmark);
            }
        });
    }
}

std::size_t LandmarkStatus::memory() const {
    const auto blocks = static_cast<std::size_t>(
        std::ranges::count_if(blocks_, [](const auto& block) { return block != nullptr; }));
    return blocks_.capacity() * sizeof(blocks_[0]) + blocks * (stride_ << kBlockShift) * sizeof(LandmarkWord);
}

}  // namespace praxis
