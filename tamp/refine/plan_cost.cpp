#include "tamp/refine/plan_cost.hpp"

#include <algorithm>

namespace praxis::tamp {
namespace {

double to_double(Rational number) {
    return static_cast<double>(number.numerator()) / static_cast<double>(number.denominator());
}

class CostEvaluator {
  public:
    CostEvaluator(const StreamTask& streams, const Samples& samples) : streams_(streams), samples_(samples) {}

    double evaluate(const Expression& expression, std::span<const ValueNumber> arguments) const {
        using Kind = Expression::Kind;
        const auto child = [&](std::size_t i) { return evaluate(expression.children[i], arguments); };
        const auto fold = [&](auto combine) {
            double result = child(0);
            for (std::size_t i = 1; i < expression.children.size(); ++i) result = combine(result, child(i));
            return result;
        };
        switch (expression.kind) {
            case Kind::constant:
                return to_double(expression.value);
            case Kind::add:
                return fold([](double a, double b) { return a + b; });
            case Kind::subtract:
                return fold([](double a, double b) { return a - b; });
            case Kind::multiply:
                return fold([](double a, double b) { return a * b; });
            case Kind::divide:
                return fold([](double a, double b) { return a / b; });
            case Kind::negate:
                return -child(0);
            case Kind::function:
                break;
        }
        return function(expression, arguments);
    }

  private:
    double function(const Expression& expression, std::span<const ValueNumber> arguments) const {
        std::vector<ValueNumber> values;
        for (const Term term : expression.terms)
            values.push_back(term.is_variable() ? arguments[term.variable_index()]
                                                : term.object_id().index());
        const FunctionTable& table = streams_.task->initial_values[expression.function.index()];
        for (std::size_t i = 0; i < table.tuples.count; ++i)
            if (std::ranges::equal(table.tuples.tuple(i), values, {}, &ObjectId::index))
                return to_double(table.values[i]);
        for (std::size_t i = 0; i < streams_.functions.size(); ++i)
            if (streams_.functions[i].function == expression.function) return samples_.cost(i, values);
        return 0;
    }

    const StreamTask& streams_;
    const Samples& samples_;
};

}  // namespace

double plan_cost(const StreamTask& streams, const Skeleton& skeleton, const Samples& samples,
                 std::span<const ValueNumber> values) {
    if (!streams.task->minimize_cost) return static_cast<double>(skeleton.plan.steps.size());
    const CostEvaluator evaluator(streams, samples);
    double cost = 0;
    std::vector<ValueNumber> arguments;
    for (std::size_t s = 0; s < skeleton.plan.steps.size(); ++s) {
        const Schema& schema = streams.task->schemas[skeleton.plan.steps[s].schema.index()];
        if (!schema.cost) continue;
        arguments.clear();
        for (const std::uint32_t slot : skeleton.arguments[s]) arguments.push_back(values[slot]);
        cost += evaluator.evaluate(*schema.cost, arguments);
    }
    return cost;
}

}  // namespace praxis::tamp
