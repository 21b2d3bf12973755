// Values of the derived variables of a state.
//
// Forward chaining with counters: every axiom counts the conditions of its body that do not hold yet; a fact
// that becomes true counts down the axioms it occurs in; at zero the axiom fires. Layers are closed one after
// the other: when a layer is done, its variables still at their default value are facts too ("negation as
// failure") and may fire axioms of later layers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Immutable; several threads may use it, each with its own scratch memory.
class AxiomEvaluator {
  public:
    explicit AxiomEvaluator(const FiniteDomainTask& task);

    class Scratch {
        friend class AxiomEvaluator;
        std::vector<std::uint32_t> unsatisfied_;
        std::vector<std::uint32_t> queue_;
    };

    /// Nothing to do: the task has no derived variables.
    bool trivial() const { return layers_.empty(); }
    /// Sets all derived variables from the others.
    void complete(std::int32_t* values, Scratch& scratch) const {
        if (!trivial()) derive(values, scratch);
    }

    /// Bytes on the heap.
    std::size_t memory() const;

  private:
    struct Derived {
        std::uint32_t variable;
        std::uint32_t default_fact;
        std::int32_t default_value;
    };
    struct Head {
        std::uint32_t variable;
        std::int32_t value;
        std::uint32_t fact;
    };
    struct Basic {
        std::uint32_t variable;
        std::uint32_t first_fact;
    };

    void derive(std::int32_t* values, Scratch& scratch) const;

    std::vector<std::vector<Derived>> layers_;
    std::vector<Basic> basic_;                  // variables that are not derived and occur in bodies
    std::vector<Head> heads_;                   // by axiom
    std::vector<std::uint32_t> body_sizes_;     // by axiom
    std::vector<std::uint32_t> unconditional_;  // axioms with an empty body
    std::vector<std::uint32_t> first_watcher_;  // by fact; one more at the end
    std::vector<std::uint32_t> watchers_;       // axioms whose body has the fact
};

}  // namespace praxis
