// The best plan so far, for engines that start from it.
#pragma once

#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

#include "search/task/ids.hpp"

namespace praxis {

/// May be used by several threads at once.
class Incumbent {
  public:
    struct Best {
        std::vector<OperatorId> plan;
        std::int64_t cost = std::numeric_limits<std::int64_t>::max();  ///< of no plan
        bool found() const { return cost != std::numeric_limits<std::int64_t>::max(); }
    };

    /// Keeps the plan if it is the best so far; says whether it is.
    bool offer(std::span<const OperatorId> plan, std::int64_t cost) {
        const std::scoped_lock lock(mutex_);
        if (cost >= best_.cost) return false;
        best_.plan.assign(plan.begin(), plan.end());
        best_.cost = cost;
        return true;
    }
    Best best() const {
        const std::scoped_lock lock(mutex_);
        return best_;
    }

  private:
    mutable std::mutex mutex_;
    Best best_;
};

}  // namespace praxis
