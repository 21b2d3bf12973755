#include "search/ground/costs.hpp"

#include <stdexcept>

#include "search/ground/refuse.hpp"

namespace praxis::grounding {

CostEvaluator::CostEvaluator(const LiftedTask& task, const Schema& schema) : task_(task), schema_(schema) {
    tables_.resize(task.functions.size());
    if (schema.cost) load(*schema.cost);
}

void CostEvaluator::load(const Expression& expression) {
    for (const Expression& child : expression.children) load(child);
    if (expression.kind != Expression::Kind::function || tables_[expression.function.index()]) return;
    const FunctionTable& initial = task_.initial_values[expression.function.index()];
    const std::vector<ColumnRange> columns(initial.tuples.arity);
    Table table{TupleStore(columns, 0), initial.values};
    tuple_.resize(std::max<std::size_t>(tuple_.size(), initial.tuples.arity));
    for (std::size_t i = 0; i < initial.tuples.count; ++i) {
        for (std::size_t c = 0; c < initial.tuples.arity; ++c) tuple_[c] = initial.tuples.tuple(i)[c].index();
        table.store.insert(tuple_.data());
    }
    tables_[expression.function.index()] = std::move(table);
}

void CostEvaluator::refuse(const std::string& message) const {
    grounding::refuse(task_, schema_.cost->where, message);
}

std::optional<Rational> CostEvaluator::evaluate(const Expression& expression, const Object* binding) {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::constant) return expression.value;
    if (expression.kind == Kind::function) {
        for (std::size_t i = 0; i < expression.terms.size(); ++i) {
            const Term term = expression.terms[i];
            tuple_[i] = term.is_variable() ? binding[term.variable_index()] : term.object_id().index();
        }
        const Table& table = *tables_[expression.function.index()];
        const Row row = table.store.find(tuple_.data());
        if (row == kNoRow) return std::nullopt;
        return table.values[row];
    }
    std::optional<Rational> result;
    for (const Expression& child : expression.children) {
        const auto value = evaluate(child, binding);
        if (!value) return std::nullopt;
        if (!result) {
            result = expression.kind == Kind::negate ? -*value : *value;
            continue;
        }
        switch (expression.kind) {
            case Kind::add:
                result = *result + *value;
                break;
            case Kind::subtract:
                result = *result - *value;
                break;
            case Kind::multiply:
                result = *result * *value;
                break;
            case Kind::divide:
                result = *result / *value;
                break;
            default:
                break;
        }
    }
    return result;
}

bool CostEvaluator::evaluate(const Object* binding) {
    value_ = Rational();
    if (!schema_.cost) return true;
    std::optional<Rational> value;
    try {
        value = evaluate(*schema_.cost, binding);
    } catch (const std::overflow_error&) {
        refuse("the cost of '" + schema_.name + "' does not fit a 64-bit fraction");
    } catch (const std::domain_error&) {
        refuse("the cost of '" + schema_.name + "' divides by zero");
    }
    if (!value) return false;
    if (*value < Rational())
        refuse("the cost of '" + schema_.name + "' is negative for some of its instances");
    value_ = *value;
    return true;
}

}  // namespace praxis::grounding
