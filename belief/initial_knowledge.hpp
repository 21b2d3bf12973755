// What is known of the first state: a deductive closure.
//
// Facts found out about the first state imply others by the clauses and groups of the initial description.
// Unit propagation finds them, in time linear in what it touches; then both values of the variables nearby
// are tried, and where one leads to a contradiction, the other holds (failed literals).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "belief/belief_task.hpp"

namespace praxis::belief {

class InitialKnowledge {
  public:
    /// Refers to the task. `consistent` is false if the description contradicts itself already.
    explicit InitialKnowledge(const BeliefTask& task);
    /// Of another state, by what holds in all states: nothing is known yet.
    static InitialKnowledge of_invariants(const BeliefTask& task);
    /// The same with what is known of a state, by variable.
    InitialKnowledge with(std::vector<std::int32_t> values) const;
    /// There is nothing to conclude from.
    bool empty() const { return empty_; }

    /// By variable, or BeliefTask::kUnknown.
    std::int32_t value(std::int32_t variable) const { return values_[static_cast<std::size_t>(variable)]; }
    bool consistent() const { return consistent_; }

    /// Adds a fact; the variables that become known, this one included, are appended to `news`. Returns
    /// false, and leaves everything as it was, if it contradicts what is known. `try_values`: also look for
    /// failed literals.
    bool learn(Fact fact, std::vector<std::int32_t>& news, bool try_values = false);

  private:
    struct Watch {
        std::uint32_t list;
        std::int32_t value;
    };

    InitialKnowledge(const BeliefTask& task, bool only_invariants, std::vector<std::int32_t> values);
    bool assign(Fact fact, std::vector<std::int32_t>& news);
    bool try_nearby(std::vector<std::int32_t>& news, std::size_t first);
    void collect_nearby(std::int32_t variable, std::vector<std::int32_t>& open) const;
    bool propagate(std::vector<std::int32_t>& news, std::size_t first);
    bool set(Fact fact, std::vector<std::int32_t>& news);
    void take_back(std::vector<std::int32_t>& news, std::size_t first);

    /// Where variables occur; copies share it.
    struct Occurrences {
        std::vector<std::vector<std::uint32_t>> clauses;  ///< by variable
        std::vector<std::vector<Watch>> groups;           ///< by variable
    };

    const BeliefTask* task_;
    std::shared_ptr<const Occurrences> occurrences_;
    std::vector<std::int32_t> values_;
    bool consistent_ = true;
    bool empty_ = true;
};

}  // namespace praxis::belief
