#include "tamp/solve/describe_values.hpp"

#include <optional>

#include "tamp/manipulation/action_motion.hpp"
#include "tamp/sampling/grasps.hpp"

namespace praxis::tamp {
namespace {

std::optional<TrajectoryDocument::Value> describe(const Value& value,
                                                  const TrajectoryDocument::Action& action) {
    const auto numbers = [](const Pose& pose) {
        const TrajectoryDocument::PoseNumbers seven = to_numbers(pose);
        return std::vector<double>(seven.begin(), seven.end());
    };
    if (const Pose* pose = value.get_if<Pose>()) return TrajectoryDocument::Value{"pose", numbers(*pose)};
    if (const Grasp* grasp = value.get_if<Grasp>()) {
        TrajectoryDocument::Value result{"grasp", numbers(grasp->body_in_tool)};
        result.numbers.push_back(grasp->opening);
        return result;
    }
    if (value.is<ActionMotion>()) return TrajectoryDocument::Value{"motion", {action.start, action.end}};
    if (const Configuration* configuration = value.get_if<Configuration>())
        return TrajectoryDocument::Value{"configuration", *configuration};
    if (const double* number = value.get_if<double>()) return TrajectoryDocument::Value{"number", {*number}};
    return std::nullopt;
}

}  // namespace

std::map<std::string, TrajectoryDocument::Value> describe_values(
    const RefinedPlan& plan, const std::vector<TrajectoryDocument::Action>& actions) {
    std::map<std::string, TrajectoryDocument::Value> result;
    for (std::size_t i = 0; i < plan.steps.size(); ++i)
        for (const Value& argument : plan.steps[i].arguments)
            if (auto described = describe(argument, actions[i]))
                result.emplace(argument.name(), std::move(*described));
    return result;
}

}  // namespace praxis::tamp
