// Planners for tests: small, on small random maps.
#pragma once

#include "learned/layers/loss.hpp"
#include "learned/maps/navigation.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

inline PlannerOptions small(const std::string& model, const std::string& group) {
    PlannerOptions options;
    options.model = model;
    options.group = group;
    options.fields = 2;
    options.iterations = 6;
    return options;
}

/// Loss of a planner on a problem; with a gradient, that too.
inline double loss_of(const Planner<double>& planner, const MapProblem& problem,
                      std::vector<double>* gradient = nullptr) {
    const auto trace = planner.trace(problem.height, problem.width);
    draw(problem, *trace);
    gradient ? planner.record(*trace) : planner.plan(*trace);
    const double loss = policy_loss(Loss::all_optimal, problem, trace->policy, 1.0, trace->of_policy);
    if (gradient) {
        gradient->assign(planner.parameters().size(), 0);
        planner.differentiate(*trace, *gradient);
    }
    return loss;
}

}  // namespace praxis::learned
