#include "tamp/manipulation/pick_place_streams.hpp"

#include <algorithm>
#include <stdexcept>

#include "tamp/collision/body_checker.hpp"

namespace praxis::tamp {

namespace {

class PickPlace {
  public:
    PickPlace(std::shared_ptr<const PickPlaceScene> scene, std::shared_ptr<const Manipulator> manipulator)
        : scene_(std::move(scene)),
          manipulator_(std::move(manipulator)),
          standing_(fixed_part(scene_->world)) {
        for (int i = 0; i < static_cast<int>(scene_->world.size()); ++i) {
            const BodyModel& body = *scene_->world[i].model;
            grasps_.push_back(body.movable ? make_grasps(body, manipulator_->effector(), grasp_options(i))
                                           : std::vector<Grasp>());
        }
    }

    StreamResult grasp(const StreamCall& call) const {
        const auto& grasps = grasps_[static_cast<std::size_t>(body(call.inputs[0]))];
        if (call.attempt < grasps.size()) return StreamResult::sample({Value::of(grasps[call.attempt])});
        return StreamResult::exhausted(
            {.reason = Reason::kinematics,
             .message = "the hand has no grasp of '" + call.inputs[0].name() + "'"});
    }

    StreamResult placement(const StreamCall& call) const {
        const int moved = body(call.inputs[0]);
        const Area& where = area(call.inputs[1]);
        const std::string names = "'" + call.inputs[0].name() + "' in '" + where.name + "'";
        if (call.attempt >= scene_->placements.count) {
            return StreamResult::exhausted({.message = "there is no place for " + names});
        }
        const std::optional<Pose> pose = make_placement(*scene_->world[moved].model, scene_->world, where,
                                                        placement_number(moved, call.attempt), scene_->placements);
        if (!pose) return StreamResult::reject({.message = "there is no room for " + names});
        if (!standing_.is_free(moved, *pose, movable_)) {
            return StreamResult::reject(
                {.reason = Reason::collision, .message = "no free place for " + names});
        }
        return StreamResult::sample({Value::of(*pose)});
    }

    StreamResult pick(const StreamCall& call) const {
        const int taken = body(call.inputs[0]);
        const World world = world_at(call.fluents).with_pose(taken, call.inputs[1].get<Pose>());
        return answer(
            call, manipulator_->pick(world, taken, call.inputs[2].get<Grasp>(), call.budget, call.attempt));
    }

    StreamResult place(const StreamCall& call) const {
        const int put = body(call.inputs[0]);
        return answer(call, manipulator_->place(world_at(call.fluents), put, call.inputs[2].get<Grasp>(),
                                                call.inputs[1].get<Pose>(), call.budget, call.attempt));
    }

  private:
    /// Numbers of the bodies that can be moved are kept aside: they are not looked at.
    BodyChecker fixed_part(const World& world) {
        for (int i = 0; i < static_cast<int>(world.size()); ++i) {
            if (world[i].model->movable) movable_.push_back(i);
        }
        return BodyChecker(std::make_shared<const World>(world));
    }

    GraspOptions grasp_options(int body) const {
        GraspOptions options = scene_->grasps;
        const auto kinds = scene_->grasp_kinds.find(body);
        if (kinds == scene_->grasp_kinds.end()) return options;
        const auto has = [&](GraspKind kind) {
            return std::ranges::find(kinds->second, kind) != kinds->second.end();
        };
        options.top = options.top && has(GraspKind::top);
        options.side = options.side && has(GraspKind::side);
        return options;
    }

    /// Every body begins with another of the places, so that several do not want the same one first.
    std::uint32_t placement_number(int body, std::uint32_t attempt) const {
        const auto turns = static_cast<std::uint32_t>(std::max<std::size_t>(scene_->placements.yaws.size(), 1));
        const std::uint32_t places = (scene_->placements.count + turns - 1) / turns;
        const std::uint32_t begin = attempt / places * places;
        const std::uint32_t size = std::min(places, scene_->placements.count - begin);
        return begin + (attempt - begin + static_cast<std::uint32_t>(body)) % size;
    }

    int body(const Value& value) const {
        const auto found = scene_->bodies.find(value.name());
        if (found == scene_->bodies.end()) {
            throw std::invalid_argument("the scene has no body for '" + value.name() + "'");
        }
        return found->second;
    }

    const Area& area(const Value& value) const {
        const auto found = scene_->areas.find(value.name());
        if (found == scene_->areas.end()) {
            throw std::invalid_argument("the scene has no region '" + value.name() + "'");
        }
        return found->second;
    }

    World world_at(std::span<const FluentAtom> fluents) const {
        World world = scene_->world;
        for (const FluentAtom& atom : fluents) {
            if (atom.predicate == "at")
                world = world.with_pose(body(atom.arguments[0]), atom.arguments[1].get<Pose>());
        }
        return world;
    }

    StreamResult answer(const StreamCall& call, ActionResult result) const {
        if (result) return StreamResult::sample({Value::of(std::move(*result.motion))});
        ActionFailure& failure = result.failure;
        Blame blame{.reason = static_cast<Reason>(failure.reason),
                    .message = failure.message,
                    .each = failure.each,
                    .definite = failure.definite};
        for (const int at_fault : failure.bodies) {
            for (std::uint32_t i = 0; i < call.fluents.size(); ++i) {
                if (body(call.fluents[i].arguments[0]) == at_fault) blame.fluents.push_back(i);
            }
        }
        const bool definite = failure.definite;
        blame.picture = Value::of(std::move(failure));
        return definite ? StreamResult::exhausted(std::move(blame)) : StreamResult::reject(std::move(blame));
    }

    std::shared_ptr<const PickPlaceScene> scene_;
    std::shared_ptr<const Manipulator> manipulator_;
    std::vector<int> movable_;
    BodyChecker standing_;
    std::vector<std::vector<Grasp>> grasps_;  ///< by body
};

}  // namespace

void bind_pick_place(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene,
                     std::shared_ptr<const Manipulator> manipulator) {
    constexpr std::uint32_t kMotionTries = 3;
    const auto skills = std::make_shared<const PickPlace>(std::move(scene), std::move(manipulator));
    library.bind("sample-grasp", [skills](StreamCall& call) { return skills->grasp(call); }, {.effort = 1});
    library.bind("sample-placement", [skills](StreamCall& call) { return skills->placement(call); },
                 {.effort = 3});
    const StreamInfo motion{.effort = 1000, .max_samples = 1, .max_attempts = kMotionTries};
    library.bind(
        "plan-pick", [skills](StreamCall& call) { return skills->pick(call); }, motion);
    library.bind(
        "plan-place", [skills](StreamCall& call) { return skills->place(call); }, motion);
}

}  // namespace praxis::tamp
