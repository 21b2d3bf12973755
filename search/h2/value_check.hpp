// Whether a set of facts leaves every variable a value, asked for many sets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/h2/pair_matrix.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Variables that lie within one word of 64 facts are looked at together. Derived variables are left out.
/// Keeps a reference to the task.
class ValueCheck {
  public:
    explicit ValueCheck(const FiniteDomainTask& task);

    /// Some value of each variable is among the facts.
    bool every_variable_has_a_value(std::span<const std::uint64_t> facts) const {
        for (std::size_t word = 0; word < facts.size(); ++word) {
            // A sum reaches a variable's last bit if and only if one of the bits below it is set.
            const std::uint64_t any = ((facts[word] & rest_[word]) + rest_[word]) | facts[word];
            if ((last_[word] & ~any) != 0) return false;
        }
        for (const std::uint32_t variable : wide_) {
            if (count_range(facts, task_.first_fact[variable], task_.first_fact[variable + 1]) == 0)
                return false;
        }
        return true;
    }

  private:
    const FiniteDomainTask& task_;
    FactBits last_, rest_;             // of the variables in one word: the last value; the others
    std::vector<std::uint32_t> wide_;  // variables in several words
};

}  // namespace praxis
