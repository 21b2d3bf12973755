#include "tamp/solve/bind_scene.hpp"

#include <cmath>
#include <stdexcept>

#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/manipulation/configuration_streams.hpp"
#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/manipulation/stacking_stream.hpp"

namespace praxis::tamp {
namespace {

/// Relative difference of what counts as one pose.
constexpr double kSamePose = 1e-9;

void check_start(const Scene& scene) {
    const std::vector<std::string> faults = check_scene(scene);
    if (faults.empty()) return;
    std::string text = "the scene cannot start so:";
    for (const std::string& fault : faults) text += "\n  " + fault;
    fail_unplaced(text);
}

void check_hand(const Scene& scene, const Manipulator& manipulator) {
    for (const BodyState& body : scene.world->bodies()) {
        if (body.attachment)
            fail_unplaced("body " + quote(body.model->name) +
                          " is held at the start; skills begin with an empty hand: put it down in the scene");
    }
    const ManipulatorModel& model = manipulator.model();
    for (std::size_t i = 0; i < model.home.size(); ++i) {
        if (std::abs(model.home[i] - scene.start[i]) < 1e-9) continue;
        fail_unplaced("the fingers are not open at the start: variable " +
                      quote(model.robot->variables[i].name) + " is " + std::to_string(scene.start[i]) +
                      ", open is " + std::to_string(model.home[i]) + "; set it in the scene's robot: start");
    }
}

std::shared_ptr<const Manipulator> make_manipulator(const Scene& scene, const SceneOptions& options) {
    try {
        return std::make_shared<const Manipulator>(scene.robot, scene.start, options.effector, options.base,
                                                   options.manipulator);
    } catch (const std::invalid_argument& error) {
        fail_unplaced(error.what());
    }
}

/// Where the bodies of `(at BODY POSE)` stand, by the names of the poses.
void add_initial_poses(const LiftedTask& task, const Scene& scene,
                       std::map<std::string, Value, std::less<>>& values) {
    for (std::size_t p = 0; p < task.predicates.size(); ++p) {
        const Relation& relation = task.initial_atoms[p];
        if (task.predicates[p].name != "at" || relation.arity != 2) continue;
        for (std::size_t i = 0; i < relation.count; ++i) {
            const std::string& body = task.objects[relation.tuple(i)[0].index()].name;
            const std::string& pose = task.objects[relation.tuple(i)[1].index()].name;
            const auto found = scene.objects.find(body);
            if (found == scene.objects.end()) {
                Suggestion suggestion(body);
                for (const auto& [name, number] : scene.objects) suggestion.consider(name);
                fail_unplaced("(at " + body + " " + pose + "): the scene has no body for " + quote(body) +
                              (suggestion.found() ? "; " + suggestion.hint() : ""));
            }
            const Pose& stands = (*scene.world)[found->second].pose;
            const auto [known, is_new] = values.try_emplace(pose, Value::of(stands));
            if (!is_new && !known->second.get<Pose>().isApprox(stands, kSamePose))
                fail_unplaced("(at " + body + " " + pose + "): " + quote(pose) +
                              " is another pose than that at which " + quote(body) + " stands in the scene");
        }
    }
}

/// The configuration of `(at-configuration Q)`.
void add_initial_configuration(const LiftedTask& task, const Configuration& start,
                               std::map<std::string, Value, std::less<>>& values) {
    for (std::size_t p = 0; p < task.predicates.size(); ++p) {
        const Relation& relation = task.initial_atoms[p];
        if (task.predicates[p].name != "at-configuration" || relation.arity != 1) continue;
        for (std::size_t i = 0; i < relation.count; ++i)
            values.try_emplace(task.objects[relation.tuple(i)[0].index()].name, Value::of(start));
    }
}

}  // namespace

BoundScene bind_scene(const StreamTask& task, const Scene& scene, const SceneOptions& options) {
    check_start(scene);
    BoundScene bound;
    bound.manipulator = make_manipulator(scene, options);
    check_hand(scene, *bound.manipulator);
    const auto places = std::make_shared<PickPlaceScene>();
    places->world = *scene.world;
    places->bodies = scene.objects;
    places->areas = areas_of(scene);
    places->grasps = options.grasps;
    places->grasp_kinds = scene.grasps;
    places->placements = options.placements;
    bind_pick_place(bound.library, places, bound.manipulator);
    bind_stacking(bound.library, places);
    bind_configurations(bound.library, places, bound.manipulator);
    for (const auto& [name, pose] : scene.poses) bound.values.emplace(name, Value::of(pose));
    add_initial_poses(*task.task, scene, bound.values);
    add_initial_configuration(*task.task, bound.manipulator->model().home, bound.values);
    return bound;
}

}  // namespace praxis::tamp
