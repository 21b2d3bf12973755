// Belief by definition: the set of all states that the world may be in. First states are all assignments to
// the uncertain atoms that satisfy the initial description; actions map every one of them, readings leave
// those that would read the same. On the lifted task, with the textbook semantics.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "belief/worlds.hpp"
#include "tests/search/support/naive_semantics.hpp"

namespace praxis::belief::test {

class NaiveBelief {
  public:
    using State = praxis::test::NaiveSemantics::State;
    /// An atom of the lifted task that holds or does not.
    using Literal = std::pair<std::size_t, bool>;

    /// Keeps a reference to the task.
    explicit NaiveBelief(const BeliefTask& task);

    /// All states that the initial description allows.
    std::vector<State> first_states() const;
    bool applicable(std::uint32_t action, const State& state) const;
    /// More than one where the action leaves atoms open.
    std::vector<State> successors(std::uint32_t action, const State& state) const;
    /// What is read in a state after the action (Environment::kStart: before the first one), without
    /// duplicates.
    std::vector<Literal> readings(std::uint32_t action, const State& state) const;
    bool goal(const State& state) const { return semantics_.goal(state); }

    /// What sensing models show of observable atoms after an action.
    std::vector<Literal> model_readings(std::uint32_t action, const State& state) const;

    /// What a fact of the physical task says; nothing for "none of those" and what is no part of the state.
    std::optional<Literal> literal(Fact fact) const { return literals_[task_.physical->fact_number(fact)]; }
    /// Some fact of the physical task is about the atom.
    bool represented(std::size_t atom) const { return represented_[atom]; }
    /// A state of the physical task; atoms that it has no facts for are as they are at first.
    State of(const WorldState& state) const;
    /// The atoms that the initial description leaves open.
    const std::vector<std::size_t>& uncertain() const { return uncertain_; }

    std::string atom_name(std::size_t atom) const { return semantics_.atom_name(atom); }

  private:
    struct GroundAction {
        std::size_t schema;
        praxis::test::NaiveSemantics::Tuple arguments;
    };
    GroundAction find(std::uint32_t action) const;
    std::size_t atom(const GroundLiteral& literal) const;
    bool allowed(const State& state) const;
    bool decided(const MultiValuedVariable& variable) const;
    std::size_t values_holding(const MultiValuedVariable& variable, const State& state) const;
    /// The states in which the atom, or the whole multi-valued variable that it belongs to, is left open.
    std::set<State> opened(std::size_t atom, State state) const;
    template <class Visit>
    void bindings(const std::vector<std::uint32_t>& variables, const Scope& scope,
                  praxis::test::NaiveSemantics::Tuple& values, std::size_t next, const Visit& visit) const;
    /// Calls visit(atom) for the atoms that an observation is about in a state.
    template <class Described, class Visit>
    void atoms(const Described& described, const Scope& scope,
               const praxis::test::NaiveSemantics::Tuple& arguments, const State& state,
               const Visit& visit) const;

    const BeliefTask& task_;
    LiftedTask lifted_;  ///< observable atoms that conditions mention are derived
    praxis::test::NaiveSemantics semantics_;
    std::vector<std::optional<Literal>> literals_;  ///< by physical fact
    std::vector<bool> represented_;                 ///< by atom
    std::vector<std::size_t> uncertain_;
    std::vector<GroundAction> actions_;
};

}  // namespace praxis::belief::test
