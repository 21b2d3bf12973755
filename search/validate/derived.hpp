// Derived predicates: strata by strongly connected components, each computed to its least fixpoint,
// semi-naively.
//
// A component is computed only when a condition asks for one of its predicates, and again only if a fact that
// it depends on has changed since. Within a component every new tuple is joined into the axioms at each place
// where its predicate occurs; only axioms that use their own component under a universal quantifier are run
// again as a whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/validate/evaluator.hpp"

namespace praxis::validation {

class DerivedPredicates {
  public:
    /// Keeps references to all three. Throws UnsupportedError if a predicate depends on its own negation.
    DerivedPredicates(const LiftedTask& task, std::vector<FactTable>& tables, Evaluator& evaluator);

    /// The components to be computed before a condition is decided, in order.
    std::vector<std::uint32_t> components_for(const Condition& condition) const;
    /// Computes these components where they are out of date.
    void update(std::span<const std::uint32_t> components);

  private:
    struct Rule {
        const Axiom* axiom = nullptr;
        Condition body;
        std::vector<std::uint32_t> head;  ///< the parameters' variables
        bool again = false;               ///< uses its own component where tuples cannot be joined in
    };

    /// A place in a rule's body where a tuple of the same component can be joined in.
    struct Occurrence {
        std::uint32_t rule = 0;
        const Condition* atom = nullptr;
        std::vector<const Condition*> rest;    ///< the conditions that must hold beside it
        std::vector<std::uint32_t> variables;  ///< of the quantifiers around it
    };

    struct Component {
        std::vector<PredicateId> predicates;
        std::vector<std::uint32_t> rules;
        std::vector<Occurrence> occurrences;
        std::vector<std::uint32_t> needs;  ///< components, itself included, in order of computation
        std::vector<PredicateId> inputs;   ///< predicates that are not derived
        std::uint64_t computed_at = 0;     ///< sum of the inputs' versions, plus one
    };

    void find_components();
    void check_strata() const;
    void find_occurrences();
    void find_inputs();
    void locate(const Condition& condition, Occurrence path, Component& component, std::uint32_t index);
    std::uint64_t version(const Component& component) const;
    void compute(Component& component);
    void run(const Rule& rule, std::span<const Condition* const> conditions);
    void join(const Component& component, PredicateId predicate, std::uint32_t row);

    const LiftedTask& task_;
    std::vector<FactTable>& tables_;
    Evaluator& evaluator_;
    std::vector<Rule> rules_;
    std::vector<std::uint32_t> component_of_;  ///< by predicate; kNone: not derived
    std::vector<Component> components_;        ///< dependencies first
    std::vector<PredicateId> queue_predicates_;
    std::vector<std::uint32_t> queue_rows_;
    std::vector<std::uint32_t> tuple_;
};

}  // namespace praxis::validation
