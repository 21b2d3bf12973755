// Formulas, effects and expressions of one scope as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parser/task.hpp"

namespace praxis::write {

/// Appends to a text what stands inside of one scope. Variables keep their names; one that would hide another
/// gets a new one.
class ScopeText {
  public:
    ScopeText(const LiftedTask& task, const Scope& scope, std::string& out);

    /// "?x - t ?y - u", after `before` if there are any.
    void parameters(const char* before);
    void formula(const Formula& formula);
    void expression(const Expression& expression);
    void atom(PredicateId predicate, const std::vector<Term>& terms);

    /// What inside() appends, under `forall` and `when` as far as there are variables and a condition.
    template <class Inside>
    void guarded(const std::vector<std::uint32_t>& variables, const Formula& condition, Inside inside) {
        const std::size_t outer = visible_.size();
        const bool conditional = condition.kind != Connective::truth;
        if (!variables.empty()) quantifier("(forall ", variables);
        if (conditional) {
            out_ += "(when ";
            formula(condition);
            out_ += ' ';
        }
        inside();
        if (conditional) out_ += ')';
        if (!variables.empty()) out_ += ')';
        visible_.resize(outer);
    }

  private:
    void quantifier(const char* head, const std::vector<std::uint32_t>& variables);
    void joined(const char* head, const std::vector<Formula>& children);
    void term(Term term);
    void bind(std::uint32_t variable);
    bool is_visible(const std::string& name) const;

    const LiftedTask& task_;
    const Scope& scope_;
    std::string& out_;
    std::vector<std::string> names_;  ///< by variable; of those that are visible
    std::vector<std::uint32_t> visible_;
};

}  // namespace praxis::write
