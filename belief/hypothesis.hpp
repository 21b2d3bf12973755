// One of the states that failed actions leave possible, as far as it is known.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "belief/derived_knowledge.hpp"
#include "belief/percept.hpp"

namespace praxis::belief {

/// What is known beside the hypotheses: the value of a variable that is neither in doubt nor derived, or
/// BeliefTask::kUnknown.
using KnownBeside = std::function<std::int32_t(std::int32_t variable)>;

class Hypothesis {
  public:
    /// `row` has a value for each of the variables in doubt. Refers to all of these; `derived` is used for
    /// one hypothesis at a time.
    Hypothesis(const BeliefTask& task, std::span<const std::int32_t> in_doubt,
               std::span<const std::int32_t> row, const KnownBeside& beside, DerivedKnowledge& derived)
        : task_(task), in_doubt_(in_doubt), row_(row), beside_(beside), derived_(derived) {}

    /// Of any variable, derived ones included; BeliefTask::kUnknown if the hypothesis leaves it open.
    std::int32_t value(std::int32_t variable);
    /// All facts hold: no, yes, or not known.
    Truth hold(std::span<const Fact> facts);
    /// The action is not known to be impossible.
    bool allows(std::uint32_t action) { return hold(precondition(action)) != Truth::known_false; }
    /// A condition of an effect holds when the action, which was possible, is executed.
    Truth fires(std::uint32_t action, std::uint32_t condition);

  private:
    std::span<const Fact> precondition(std::uint32_t action) const {
        return task_.physical->preconditions[action];
    }
    std::int32_t basic_value(std::int32_t variable) const;

    const BeliefTask& task_;
    std::span<const std::int32_t> in_doubt_, row_;
    const KnownBeside& beside_;
    DerivedKnowledge& derived_;
    bool derived_ready_ = false;
};

}  // namespace praxis::belief
