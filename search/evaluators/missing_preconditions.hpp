// How many preconditions of each rule of a relaxed task are not facts of a state: where relaxed explorations
// start.
//
// The counts are kept from one state to the next and changed only where the states differ, so that
// neighbouring states cost little. They depend on the state only, not on the states before.
#pragma once

#include <cstring>
#include <vector>

#include "search/evaluators/relaxed_task.hpp"

namespace praxis {

class MissingPreconditions {
  public:
    /// Starts with no facts at all. The task must outlive this.
    explicit MissingPreconditions(const RelaxedTask& task)
        : task_(task),
          held_(task.first_fact.size() - 1, RelaxedTask::kNone),
          counts_(task.precondition_counts) {
        counts_.resize((counts_.size() + 7) / 8 * 8, 1);
        change(RelaxedTask::kTrue, 0xFF);
    }

    /// Goes to a state and calls `visit` with each proposition that holds in it, except kTrue.
    template <class Visit>
    void enter(StateView state, const Visit& visit) {
        for (std::size_t variable = 0; variable < held_.size(); ++variable) {
            const std::uint32_t fact =
                task_.first_fact[variable] + static_cast<std::uint32_t>(state[variable]);
            const std::uint32_t proposition = task_.fact_proposition[fact];
            if (const std::uint32_t before = held_[variable]; before != proposition) {
                if (before != RelaxedTask::kNone) change(before, 1);
                if (proposition != RelaxedTask::kNone) change(proposition, 0xFF);
                held_[variable] = proposition;
            }
            if (proposition != RelaxedTask::kNone) visit(proposition);
        }
    }

    /// By rule; padded with ones to a multiple of eight.
    const std::vector<std::uint8_t>& counts() const { return counts_; }

    /// Calls `fire` with each rule that misses nothing. Looks at eight counts together.
    template <class Fire>
    void for_each_applicable(const Fire& fire) const {
        constexpr std::uint64_t kOnes = 0x0101010101010101u;
        for (std::size_t base = 0; base < counts_.size(); base += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, counts_.data() + base, 8);
            if (((word - kOnes) & ~word & (kOnes << 7)) == 0) continue;
            for (std::size_t rule = base; rule < base + 8; ++rule) {
                if (counts_[rule] == 0) fire(static_cast<std::uint32_t>(rule));
            }
        }
    }

  private:
    void change(std::uint32_t proposition, std::uint8_t by) {
        for (const std::uint32_t rule : task_.precondition_of(proposition)) {
            counts_[rule] = static_cast<std::uint8_t>(counts_[rule] + by);
        }
    }

    const RelaxedTask& task_;
    std::vector<std::uint32_t> held_;  ///< by variable: the proposition that holds, or kNone
    std::vector<std::uint8_t> counts_;
};

}  // namespace praxis
