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
#include <span>
#include <vector>

#include "belief/hypothesis.hpp"

namespace praxis::belief {

class Hypotheses {
  public:
    /// Refers to the task.
    explicit Hypotheses(const BeliefTask& task) : task_(&task), derived_(task) {}

    bool empty() const { return columns_.empty(); }
    bool about(std::int32_t variable) const { return column(variable) < columns_.size(); }
    /// The variables in doubt.
    const std::vector<std::int32_t>& variables() const { return columns_; }
    /// What is supposed of these: BeliefTask::kUnknown of an uncertain one, at times.
    const std::vector<std::int32_t>& supposed() const { return rows_.front(); }
    /// Tells hypotheses apart (up to chance).
    std::uint64_t fingerprint() const;

    /// Calls `visit(Hypothesis&)` for each one; once, for what is known beside, if nothing is in doubt.
    template <class Visit>
    void for_each(const KnownBeside& beside, const Visit& visit);

    /// The action has been executed, so it was possible. Nothing changes if that contradicts all of them.
    void allow(std::uint32_t action, const KnownBeside& beside);
    /// The action, which was possible, has happened; `variables`: what it may have changed.
    void act(std::uint32_t action, std::span<const std::int32_t> variables, const KnownBeside& beside);
    /// It has failed. Hypotheses beyond 256 are dropped.
    void fail(std::uint32_t action, std::span<const std::int32_t> variables, const KnownBeside& beside);
    /// It was refused, though possible by the first hypothesis. False, and nothing changes, if none explains
    /// that.
    bool refuse(std::uint32_t action, const KnownBeside& beside);
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
    void add(std::span<const std::int32_t> variables, const KnownBeside& beside);
    void remove_repeated();
    Hypothesis hypothesis(const Row& row, const KnownBeside& beside) {
        return {*task_, columns_, row, beside, derived_};
    }
    Row after(std::uint32_t action, const Row& row, const KnownBeside& beside);

    const BeliefTask* task_;
    DerivedKnowledge derived_;           ///< of the hypothesis that is looked at
    std::vector<std::int32_t> columns_;  ///< variables
    std::vector<Row> rows_;              ///< none if there are no columns
};

template <class Visit>
void Hypotheses::for_each(const KnownBeside& beside, const Visit& visit) {
    const std::vector<Row> none(1);
    for (const Row& row : empty() ? none : rows_) {
        Hypothesis one = hypothesis(row, beside);
        visit(one);
    }
}

}  // namespace praxis::belief
