#include "tamp/refine/refine.hpp"

#include <stdexcept>

#include "tamp/refine/refiner.hpp"

namespace praxis::tamp {

std::string_view to_string(RefineStatus status) {
    switch (status) {
        case RefineStatus::solved:
            return "solved";
        case RefineStatus::infeasible:
            return "infeasible";
        case RefineStatus::cancelled:
            return "cancelled";
        case RefineStatus::out_of_budget:
            break;
    }
    return "out of budget";
}

std::string RefinedPlan::action(std::size_t i) const {
    std::string text = "(" + steps[i].name;
    for (const Value& argument : steps[i].arguments) text += " " + argument.name();
    return text + ")";
}

Refinement refine(const RefinementProblem& problem, const Budget& budget, const RefineCallbacks& callbacks) {
    if (problem.task == nullptr || problem.task->task == nullptr)
        throw std::invalid_argument("a refinement problem needs a task");
    if (problem.library == nullptr)
        throw std::invalid_argument("a refinement problem needs a library of streams");
    if (problem.options.max_level == 0 || problem.options.max_instances == 0 ||
        problem.options.first_calls == 0)
        throw std::invalid_argument("max_level, max_instances and first_calls must be positive");
    return Refiner(problem, budget, callbacks).run();
}

}  // namespace praxis::tamp
