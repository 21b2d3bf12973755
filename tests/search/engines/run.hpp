// Running a search on a task, and arbitrary small tasks.
#pragma once

#include <rapidcheck.h>

#include <memory>
#include <string>

#include "search/engines/search.hpp"
#include "tests/search/state/random_task.hpp"

namespace praxis::test {

inline Outcome run(FiniteDomainTask task, const std::string& expression, const Budget& budget = {},
                   const SearchCallbacks& callbacks = {}, std::uint64_t seed = 0, int threads = 1) {
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(std::move(task)));
    Configuration config = configuration(expression);
    config.seed = seed;
    config.threads = threads;
    return search(prepared, task_query(prepared.task()), config, budget, callbacks);
}

inline RandomTaskOptions arbitrary_options() {
    return {.variables = *rc::gen::inRange(1, 7),
            .derived = *rc::gen::element(0, 0, 2, 4),
            .operators = *rc::gen::element(0, 5, 10, 20, 30),
            .largest_cost = *rc::gen::element(1, 5, 10000, 1000000000),
            .conditional_effects = *rc::gen::arbitrary<bool>()};
}

inline FiniteDomainTask arbitrary_task() {
    return random_task(*rc::gen::arbitrary<std::uint64_t>(), arbitrary_options());
}

}  // namespace praxis::test
