// What a ground action costs, exactly.
#pragma once

#include <optional>
#include <vector>

#include "parser/task.hpp"
#include "search/ground/tuple_store.hpp"

namespace praxis::grounding {

/// Evaluates one schema's cost expression under bindings of its parameters.
class CostEvaluator {
  public:
    CostEvaluator(const LiftedTask& task, const Schema& schema);

    /// False if a function has no value there: the action cannot be applied. Throws UnsupportedError, at the
    /// expression's place, for a negative cost and for numbers that do not fit.
    bool evaluate(const Object* binding);
    Rational value() const { return value_; }

  private:
    struct Table {
        TupleStore store{{}, 0};
        std::vector<Rational> values;
    };

    void load(const Expression& expression);
    std::optional<Rational> evaluate(const Expression& expression, const Object* binding);
    [[noreturn]] void refuse(const std::string& message) const;

    const LiftedTask& task_;
    const Schema& schema_;
    std::vector<std::optional<Table>> tables_;  ///< by function
    std::vector<Object> tuple_;
    Rational value_;
};

}  // namespace praxis::grounding
