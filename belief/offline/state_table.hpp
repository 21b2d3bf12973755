// True states of the physical task, each kept once and known by its number, and what happens in them.
//
// For questions about all states that are possible at once: a belief is then a sorted list of numbers. Exact
// where actions have no effects of chance and readings no errors.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/worlds.hpp"
#include "search/state/axiom_evaluator.hpp"

namespace praxis::belief {

/// Number of a state in a StateTable.
using StateIndex = std::uint32_t;

/// Every action does one thing and every reading is right: what plans made beforehand need.
bool certain_outcomes(const BeliefTask& task);

class StateTable {
  public:
    explicit StateTable(std::shared_ptr<const BeliefTask> task);
    StateTable(const StateTable&) = delete;
    StateTable& operator=(const StateTable&) = delete;

    const BeliefTask& task() const { return *task_; }
    std::size_t size() const { return index_.size(); }
    /// By variable, the derived ones included. Valid until the next state is added.
    const std::int32_t* values(StateIndex state) const { return values_.data() + state * width_; }

    /// The derived variables are computed.
    StateIndex add(const WorldState& state);
    bool applicable(StateIndex state, std::uint32_t action) const {
        return all_hold(task_->physical->preconditions[action], values(state));
    }
    bool goal(StateIndex state) const { return all_hold(task_->physical->goal, values(state)); }
    /// After an action that is applicable.
    StateIndex successor(StateIndex state, std::uint32_t action);
    /// All that is answered in `state` after `action` (Environment::kStart: at first): the facts that are
    /// found to hold, sorted, each once.
    std::vector<Fact> observation(StateIndex state, std::uint32_t action) const;

  private:
    struct Hash {
        const StateTable* table;
        std::size_t operator()(StateIndex state) const;
    };
    struct Equal {
        const StateTable* table;
        bool operator()(StateIndex a, StateIndex b) const;
    };

    StateIndex intern(const std::vector<std::int32_t>& values);
    void answer(StateIndex state, Fact fact, std::vector<Fact>& answers) const;

    std::shared_ptr<const BeliefTask> task_;
    AxiomEvaluator axioms_;
    AxiomEvaluator::Scratch scratch_;
    std::size_t width_;
    std::vector<std::int32_t> values_;  // width_ a state
    std::vector<std::int32_t> next_;
    std::unordered_set<StateIndex, Hash, Equal> index_;
};

/// One thing that may be answered, and the states in which it is.
struct Answered {
    std::vector<Fact> observation;
    std::vector<StateIndex> states;  ///< sorted
};

/// Sorts states by what is answered after `action`.
std::vector<Answered> split_by_observation(const StateTable& table, std::span<const StateIndex> states,
                                           std::uint32_t action);

}  // namespace praxis::belief
