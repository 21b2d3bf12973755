// What may be the case after actions that failed.
//
// A skill that fails may have done its work or not: each state that was possible before is possible still,
// and so is what the action makes of it (as a whole, or not at all). A *hypothesis* is one of these states,
// as far as they differ: a row of values, a column for each variable that is *in doubt*. An uncertain
// variable in doubt is not known. A certain one has no value that says so: plans *suppose* the first
// hypothesis. A reading, an action that the world executes, one that it refuses, each leaves the hypotheses
// that agree with it; another failure that a hypothesis explains makes it the first. Where all that are left
// agree, nothing is in doubt.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/percept.hpp"

namespace praxis::belief {

class Hypotheses {
  public:
    /// The value of a variable that is not in doubt, or is derived (then by the first hypothesis);
    /// BeliefTask::kUnknown if it is not known.
    using Value = std::function<std::int32_t(std::int32_t variable)>;

    bool empty() const { return columns_.empty(); }
    bool about(std::int32_t variable) const { return column(variable) < columns_.size(); }
    /// The variables in doubt.
    const std::vector<std::int32_t>& variables() const { return columns_; }
    /// What is supposed of these: BeliefTask::kUnknown of an uncertain one, at times.
    const std::vector<std::int32_t>& supposed() const { return rows_.front(); }
    /// Tells hypotheses apart (up to chance).
    std::uint64_t fingerprint() const;

    /// The action has been executed.
    void act(const BeliefTask& task, std::uint32_t action, const Value& value);
    /// It has failed; `variables`: what it may have changed. Hypotheses beyond 256 are dropped.
    void fail(const BeliefTask& task, std::uint32_t action, std::span<const std::int32_t> variables,
              const Value& value);
    /// It was refused, though possible by the first hypothesis. False, and nothing changes, if none explains
    /// that.
    bool refuse(const BeliefTask& task, std::uint32_t action, const Value& value);
    /// The fact holds. If no hypothesis agrees, the first is changed.
    void learn(Fact fact);
    /// The second hypothesis is supposed, and the first one comes last.
    void turn();
    void forget(std::int32_t variable);

    /// Takes out the variables about which all hypotheses agree: their values, or kUnknown.
    std::vector<Fact> settle();

  private:
    using Row = std::vector<std::int32_t>;

    std::size_t column(std::int32_t variable) const;
    void add(std::int32_t variable, const Value& value);
    void remove_repeated();
    std::int32_t value(const Row& row, std::int32_t variable, const Value& value) const;
    /// Whether all facts hold in the row: no, yes, or not known.
    Truth hold(const Row& row, std::span<const Fact> facts, const Value& value) const;
    Row after(const BeliefTask& task, std::uint32_t action, const Row& row, const Value& value) const;

    std::vector<std::int32_t> columns_;  ///< variables
    std::vector<Row> rows_;              ///< none if there are no columns
};

}  // namespace praxis::belief
