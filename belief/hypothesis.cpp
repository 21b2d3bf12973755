#include "belief/hypothesis.hpp"

#include <algorithm>

namespace praxis::belief {

std::int32_t Hypothesis::basic_value(std::int32_t variable) const {
    const auto place = std::find(in_doubt_.begin(), in_doubt_.end(), variable);
    return place == in_doubt_.end() ? beside_(variable)
                                    : row_[static_cast<std::size_t>(place - in_doubt_.begin())];
}

std::int32_t Hypothesis::value(std::int32_t variable) {
    if (!task_.physical->derived(variable)) return basic_value(variable);
    if (!derived_ready_) derived_.update([this](std::int32_t basic) { return basic_value(basic); });
    derived_ready_ = true;
    return derived_.value(variable);
}

Truth Hypothesis::hold(std::span<const Fact> facts) {
    Truth result = Truth::known_true;
    for (const Fact& fact : facts) {
        const std::int32_t now = value(fact.variable);
        if (now == BeliefTask::kUnknown)
            result = Truth::unknown;
        else if (now != fact.value)
            return Truth::known_false;
    }
    return result;
}

Truth Hypothesis::fires(std::uint32_t action, std::uint32_t condition) {
    const auto given = precondition(action);
    Truth result = Truth::known_true;
    for (const Fact& fact : task_.physical->conditions[condition]) {
        if (std::find(given.begin(), given.end(), fact) != given.end()) continue;
        const Truth holds = hold({&fact, 1});
        if (holds == Truth::known_false) return holds;
        if (holds == Truth::unknown) result = holds;
    }
    return result;
}

}  // namespace praxis::belief
