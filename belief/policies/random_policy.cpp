#include "belief/policies/random_policy.hpp"

namespace praxis::belief {

Decision RandomPolicy::next(Belief& belief, const Budget&) {
    const std::size_t count = belief.compilation().belief().operator_count();
    possible_.clear();
    for (std::uint32_t action = 0; action < count; ++action)
        if (any_ || belief.can(action)) possible_.push_back(action);
    if (possible_.empty()) return {};
    return {Decision::Kind::act, possible_[random_.below(possible_.size())]};
}

}  // namespace praxis::belief
