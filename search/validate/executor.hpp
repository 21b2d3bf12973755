// Executes ground actions on a lifted task, one after the other, and explains why one cannot be executed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parser/task.hpp"
#include "search/plan.hpp"
#include "search/validate/derived.hpp"

namespace praxis::validation {

class Executor {
  public:
    /// Starts in the initial state. Keeps a reference to the task. Throws UnsupportedError as
    /// DerivedPredicates does.
    explicit Executor(const LiftedTask& task);
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    /// Changes the state and adds to the cost; or leaves both and says why the step cannot be executed.
    std::optional<std::string> execute(const PlanStep& step);
    /// Why the goal does not hold; nothing if it does.
    std::optional<std::string> goal_failure();
    /// By the task's metric.
    Rational cost() const { return cost_; }

    /// The state at hand, by predicate, and what decides conditions in it. Derived predicates hold what they
    /// held when they were last updated.
    std::vector<FactTable>& tables() { return tables_; }
    Evaluator& evaluator() { return evaluator_; }
    DerivedPredicates& derived() { return derived_; }

  private:
    /// A part of a conjunction, to be tested and reported by itself.
    struct Conjunct {
        const Formula* formula = nullptr;
        Condition condition;
    };
    struct CompiledEffect {
        const Effect* effect = nullptr;
        Condition condition;
        std::vector<std::uint32_t> wanted;  ///< the quantified variables among the terms
    };
    struct CompiledSchema {
        std::vector<Conjunct> precondition;
        std::vector<CompiledEffect> effects;
        std::vector<std::uint32_t> components;
    };

    const CompiledSchema& compiled(SchemaId schema);
    void split(const Formula& formula, std::vector<Conjunct>& out) const;
    std::optional<std::string> misfit(const PlanStep& step) const;
    /// The conjuncts that are false now, in words; empty if there is none.
    std::string failures(const std::vector<Conjunct>& conjuncts, const Scope& scope);
    std::string counterexample(const Conjunct& conjunct, const Scope& scope);
    void collect(const CompiledEffect& effect);
    void apply();
    Rational evaluate(const Expression& expression) const;

    const LiftedTask& task_;
    std::vector<FactTable> tables_;
    std::vector<FactTable> functions_;  ///< row i has the value i of the function's table
    Evaluator evaluator_;
    DerivedPredicates derived_;
    std::vector<std::unique_ptr<CompiledSchema>> schemas_;
    std::vector<std::uint32_t> changes_[2];  ///< deletes and adds: predicate, arguments, predicate, ...
    Rational cost_;
};

}  // namespace praxis::validation
