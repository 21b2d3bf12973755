// Makes a Compilation: one class, its parts in a file each.
//
//   variables.cpp   the variables of the compiled task, and what "known" and "possible" are among them
//   deduction.cpp   what follows from clauses: axioms, and what a reading implies at once
//   effects.cpp     what an action does to knowledge
//   operators.cpp   actions, their readings, sensors
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "belief/compilation.hpp"

namespace praxis::belief {

class Compiler {
  public:
    explicit Compiler(Compilation& result)
        : result_(result),
          belief_(*result.belief_),
          physical_(*belief_.physical),
          task_(std::make_shared<FiniteDomainTask>()) {}

    void run();

  private:
    using Condition = std::vector<Fact>;
    /// Costs of the compiled task are in these units; a passive sensor's outcome costs one.
    static constexpr std::int64_t kActionUnit = 10;

    static Fact opposite(Fact fact) { return {fact.variable, 1 - fact.value}; }
    /// Sorted by variable; nothing if it contradicts itself.
    static std::optional<Condition> conjunction(Condition facts);

    bool uncertain(std::int32_t variable) const { return belief_.uncertain[index(variable)]; }
    std::size_t number(Fact fact) const { return physical_.fact_number(fact); }
    bool tracked(std::int32_t variable) const { return result_.tracked(variable); }
    Fact known(Fact fact);
    /// The fact that says that a physical fact is possible. Its opposite must be derived knowledge if
    /// it is uncertain.
    Fact possible(Fact fact);
    void find_changeable();
    /// The number of a clause or group as a variable of the compiled task, or kAlways if no action changes
    /// anything in it, or it holds in all states.
    std::size_t guard(std::span<const Fact> facts, bool invariant);
    /// Which knowledge can be deduced, and which is needed as a derived variable.
    void collect_axioms();
    /// Why something is known: the facts of the condition are, and the clause still says something.
    struct Reason {
        Condition facts;
        std::size_t clause;
    };
    static constexpr std::size_t kAlways = static_cast<std::size_t>(-1);
    void add_deduction(Fact head, Reason reason);
    std::int32_t add_variable(std::int32_t size, std::int32_t layer, std::int32_t initial);
    std::uint32_t symbol(const std::string& word);
    /// Names a fact "PREFIX physical-fact".
    void name(const char* prefix, std::optional<Fact> fact);
    void make_variables();
    void number_facts();
    void make_slots();
    const CompiledComponent& slots_of(std::int32_t variable) const;
    Fact in_slot(Fact fact, std::size_t slot) const;
    Fact add_derived(const char* prefix, Fact fact);
    Fact known_in_all_cases(Fact fact);
    Fact possible_in_some_case(Fact fact);
    void make_variable(std::int32_t v);
    void add_axiom(Fact head, Condition body);
    void make_axioms();
    std::uint32_t condition(const Condition& facts);
    void add_effect(std::vector<GroundEffect>& effects, Fact fact, Condition facts);
    /// What an action does to knowledge, but for its readings.
    std::vector<GroundEffect> knowledge_effects(std::size_t o);
    /// Nothing is deduced any more from clauses in which the action may change something.
    void close_clauses(std::size_t o, std::vector<GroundEffect>& effects);
    /// Only one effect of the operator is about the variable.
    bool alone(std::size_t o, std::int32_t variable) const;
    /// What else is known of the first state once `fact` is, by clauses of two and by groups.
    const std::vector<Fact>& implied(Fact fact);
    void index_implications();
    void add_operator(const Condition& precondition, const std::vector<GroundEffect>& effects,
                      std::int64_t cost, CompiledOperator origin, const std::vector<std::uint32_t>& words);
    /// What it costs to assume that a reading has this outcome (see CompilationOptions::risk).
    std::int64_t risk_of(Fact outcome);
    double probability(Fact fact);
    /// Both outcomes of a reading.
    void add_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
                      std::int64_t cost, CompiledOperator origin, std::vector<std::uint32_t> words,
                      Fact read);
    void add_case_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
                           std::int64_t cost, CompiledOperator origin,
                           const std::vector<std::uint32_t>& words, Fact read);
    /// Actions whose readings are steps of their own: those with several, and those that read what they
    /// change.
    void find_moments();
    /// The knowledge that something asks for; a reading that can only tell something else is of no use in a
    /// plan.
    void find_needed();
    void make_operators();
    void make_sensors();
    /// Groups of the physical task hold for knowledge, too: two facts that exclude each other are not both
    /// known.
    void add_mutex_groups();

    Compilation& result_;
    const BeliefTask& belief_;
    const FiniteDomainTask& physical_;
    std::shared_ptr<FiniteDomainTask> task_;
    std::vector<bool> deduced_;          ///< by physical fact: knowledge of it is a derived variable
    std::vector<bool> changeable_;       ///< by physical variable: some action has an effect on it
    std::vector<std::int32_t> moments_;  ///< by operator: its value of the moment variable, or 0
    std::vector<std::vector<std::uint32_t>> guards_of_;  ///< by physical variable: guarded clauses
    std::set<Fact> needed_;                              ///< compiled facts that something asks for
    std::vector<bool> readable_;                         ///< by physical variable
    std::vector<std::vector<Reason>> reasons_;           ///< by physical fact: what it is deduced from
    std::vector<Fact> possible_;                         ///< by physical fact, of derived variables
    std::map<std::string, std::uint32_t> symbols_;
    std::map<Condition, std::uint32_t> conditions_;
    std::vector<std::vector<Fact>> neighbours_;          ///< by physical fact: implied by it
    std::vector<std::vector<std::uint32_t>> groups_of_;  ///< by physical fact
    std::vector<std::vector<Fact>> implied_;             ///< by physical fact
    std::vector<char> implied_done_;
};

}  // namespace praxis::belief
