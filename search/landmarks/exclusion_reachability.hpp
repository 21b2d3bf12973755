// What the delete relaxation can reach as long as a set of facts is not reached.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/evaluators/relaxed_rules.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Explores the same task again and again, each time without some facts. Refers to the task.
class ExclusionReachability {
  public:
    /// `initial_values` are complete.
    ExclusionReachability(const FiniteDomainTask& task, std::span<const Fact> goal,
                          std::span<const std::int32_t> initial_values);

    const relaxed::Rules& rules() const { return rules_; }
    const relaxed::Achievers& achievers() const { return achievers_; }

    /// The facts (by number; none holds initially) are never reached, and operators that are sure to reach
    /// one of them are not applied.
    void explore(std::span<const std::uint32_t> excluded);

    /// About the latest exploration: the fact may hold in a state before any excluded one does.
    bool reached(std::uint32_t fact) const { return reached_[fact] != 0; }
    /// All preconditions of the rule are reached.
    bool applicable(std::uint32_t rule) const { return unreached_[rule] == 0; }
    /// The rule is of an operator that is sure to reach an excluded fact.
    bool barred(std::uint32_t rule) const { return barred_[rules_.operators[rule]] == stamp_; }

    /// Elementary steps so far.
    std::uint64_t work() const { return work_; }

  private:
    void bar_sure_achievers(std::uint32_t excluded);
    bool surely_reaches(std::uint32_t op, Fact fact) const;
    void fire(std::uint32_t rule);

    const FiniteDomainTask& task_;
    relaxed::Rules rules_;
    relaxed::Achievers achievers_;
    std::vector<std::int32_t> variable_of_;  ///< by fact of the task
    std::vector<std::uint32_t> users_begin_;
    std::vector<std::uint32_t> users_;
    // At the start: after the initial facts have been counted.
    std::vector<char> initially_reached_;
    std::vector<std::uint32_t> initially_unreached_;
    std::vector<std::uint32_t> initially_applicable_;

    std::vector<char> reached_;             ///< by fact; excluded facts: 0
    std::vector<std::uint32_t> unreached_;  ///< by rule: preconditions not reached
    std::vector<std::uint32_t> excluded_;   ///< by fact: stamp
    std::vector<std::uint32_t> barred_;     ///< by operator: stamp
    std::vector<std::uint32_t> queue_;
    std::uint32_t stamp_ = 0;
    std::uint64_t work_ = 0;
};

}  // namespace praxis
