// The states still to be expanded, in two queues that take turns: the new ones first, and the near ones
// first.
#pragma once

#include <cstddef>
#include <cstdint>

#include "search/engines/bucket_queue.hpp"
#include "search/lifted/relaxed_plan.hpp"
#include "search/lifted/state_store.hpp"

namespace praxis::lifted {

class OpenQueues {
  public:
    /// What is known of a state.
    struct Estimate {
        std::uint32_t missing;  ///< goals
        std::uint32_t to_make;  ///< atoms of the relaxed plan not made true so far
        int novelty;
    };

    explicit OpenQueues(std::size_t goal_count) : goal_count_(static_cast<std::int64_t>(goal_count)) {}

    void push(StateNumber state, Estimate estimate) {
        const auto push_to = [&](Fifo<StateNumber>& bucket) { bucket.push(pool_, state); };
        novel_.fill(estimate.novelty * (goal_count_ + 1) + estimate.missing, push_to);
        const std::int64_t way = estimate.missing * std::int64_t{RelaxedPlan::kMost + 1} + estimate.to_make;
        near_.fill(way * 4 + estimate.novelty, push_to);
    }
    bool empty() const { return novel_.empty() && near_.empty(); }
    /// A state comes out of each queue once.
    StateNumber pop() {
        const auto take = [&](Fifo<StateNumber>& bucket) { return bucket.pop(pool_); };
        near_turn_ = !near_turn_;
        const bool near = novel_.empty() || (near_turn_ && !near_.empty());
        return near ? near_.take(take) : novel_.take(take);
    }

  private:
    std::int64_t goal_count_;
    ChunkPool<StateNumber> pool_;
    KeyedBuckets<Fifo<StateNumber>> novel_, near_;
    bool near_turn_ = false;
};

}  // namespace praxis::lifted
