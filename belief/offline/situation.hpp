// A belief on the way of a conditional plan, and what actions and answers make of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "belief/belief.hpp"
#include "belief/offline/state_table.hpp"

namespace praxis::belief {

struct Situation {
    Belief belief;
    std::vector<StateIndex> states;  ///< sorted; empty where states are not counted

    /// Which situations are one.
    std::vector<std::uint32_t> key() const;
};

struct SituationOutcome {
    std::vector<Fact> observation;
    Situation situation;
};

class Situations {
  public:
    /// `table`: none if states are not counted. Refers to its arguments.
    Situations(const BeliefTask& task, StateTable* table, std::size_t most_outcomes)
        : task_(&task), table_(table), most_outcomes_(most_outcomes) {}

    bool goal(const Situation& situation) const;
    /// The action's precondition is known to hold.
    bool can(const Situation& situation, std::uint32_t action) const;
    /// What may be answered after an action (Environment::kStart: before the first one); nothing if that is
    /// too much, or if the belief contradicts the states.
    std::optional<std::vector<SituationOutcome>> outcomes(const Situation& situation,
                                                          std::uint32_t action) const;

  private:
    std::optional<std::vector<SituationOutcome>> counted(const Situation& situation,
                                                         std::uint32_t action) const;
    std::optional<std::vector<SituationOutcome>> uncounted(const Situation& situation,
                                                           std::uint32_t action) const;
    bool tell(Situation& situation, const std::vector<Fact>& observation) const;

    const BeliefTask* task_;
    StateTable* table_;
    std::size_t most_outcomes_;
};

}  // namespace praxis::belief
