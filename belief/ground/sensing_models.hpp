// Sensing models as ordinary readings.
//
// What a model says of an observable atom after an action is a condition on the state: the atom reads true
// where one of its rules applies. What the action makes certain is left out of it. Then
//   - a condition that is always or never true tells nothing,
//   - one fact alone is read itself,
//   - everything else becomes a variable that is *defined*: clauses make it equal to its condition in the
//   first
//     state, and every action that changes something in the condition has effects that keep it so.
// Observable atoms that conditions mention are always defined, by the whole condition; it has to be the same
// in all models.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/ground/conditions.hpp"
#include "belief/ground/observables.hpp"

namespace praxis::belief {

class SensingModels {
  public:
    SensingModels(std::shared_ptr<const ContingentTask> source,
                  std::shared_ptr<const FiniteDomainTask> ground, const Conditions& conditions);

    /// Adds what the schema's model reads in states of which `after` is known. Throws UnsupportedError.
    void read(std::size_t schema, std::span<const ObjectId> arguments, const Context& after,
              PackedLists<GroundReading>& readings);

    /// Once everything has been read: adds the defined variables, and the effects that keep them right.
    void extend(FiniteDomainTask& physical);
    /// Says what the defined variables are at first; `task.initial_values` has what is certain of the others.
    /// `always`: also of all other states.
    void begin(BeliefTask& task, FiniteDomainTask& physical, bool always);
    /// The variables whose definitions mention some of these; after `extend`.
    std::set<std::int32_t> depending(const std::set<std::int32_t>& variables) const;

  private:
    using Atom = std::pair<PredicateId, std::vector<ObjectId>>;
    struct Observed {
        Dnf condition;
        bool value = true;  ///< what the atom reads where the condition holds
        Location where;
    };

    const std::vector<SensingRule>& rules_of(std::size_t schema) const;
    void define_the_rest();
    Fact defined(const Atom& atom, const Observed& observed);
    Fact asked(const Atom& atom, const Observed& observed);
    std::vector<GroundEffect> effects(std::size_t o, FiniteDomainTask& physical);
    std::uint32_t condition(const Dnf::Term& facts, FiniteDomainTask& physical);
    void equate(Fact fact, const Dnf& condition, bool invariant, BeliefTask& task,
                FiniteDomainTask& physical);
    Fact helper(const Dnf::Term& term, BeliefTask& task, FiniteDomainTask& physical);
    std::uint32_t symbol(const std::string& word, FiniteDomainTask& physical);

    std::shared_ptr<const ContingentTask> source_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    const Conditions& conditions_;
    Observables observables_;
    Context open_;

    std::vector<GroundDefinition> definitions_;
    std::vector<Atom> fresh_;                   ///< atoms of the variables that the ground task does not have
    std::vector<std::set<std::size_t>> about_;  ///< by variable: the definitions that mention it
    std::map<Dnf, Fact> defined_;
    std::map<Atom, std::size_t> asked_;  ///< definitions of the atoms that conditions mention
    std::map<Dnf::Term, std::uint32_t> made_conditions_;
    std::map<std::string, std::uint32_t> symbols_;
};

}  // namespace praxis::belief
