#include "tests/search/support/naive_validator.hpp"

#include "tests/search/support/naive_semantics.hpp"

namespace praxis::test {

std::size_t naive_failure(const LiftedTask& task, const Plan& plan) {
    const NaiveSemantics semantics(task);
    NaiveSemantics::State state = semantics.initial();
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const Schema& schema = task.schemas[plan.steps[i].schema.index()];
        NaiveSemantics::Tuple arguments;
        for (const ObjectId object : plan.steps[i].arguments) arguments.push_back(object.index());
        if (!semantics.applicable(schema, arguments, state)) return i + 1;
        state = semantics.successor(schema, arguments, state);
    }
    return semantics.goal(state) ? 0 : plan.steps.size() + 1;
}

}  // namespace praxis::test
