#include "tamp/manipulation/pick_place_streams.hpp"

#include <algorithm>
#include <stdexcept>

#include "tamp/collision/body_checker.hpp"
#include "tamp/manipulation/scene_lookup.hpp"

namespace praxis::tamp {

namespace {

class PickPlace {
  public:
    PickPlace(std::shared_ptr<const PickPlaceScene> scene, std::shared_ptr<const Manipulator> manipulator)
        : scene_(std::move(scene)),
          manipulator_(std::move(manipulator)),
          standing_(fixed_part(scene_.scene().world)) {
        for (int i = 0; i < static_cast<int>(scene_.scene().world.size()); ++i) {
            const BodyModel& body = *scene_.scene().world[i].model;
            grasps_.push_back(body.movable ? make_grasps(body, manipulator_->effector(), grasp_options(i))
                                           : std::vector<Grasp>());
        }
    }

    StreamResult grasp(const StreamCall& call) const {
        const auto& grasps = grasps_[static_cast<std::size_t>(scene_.body(call.inputs[0]))];
        if (call.attempt < grasps.size()) return StreamResult::sample({Value::of(grasps[call.attempt])});
        if (!grasps.empty()) return StreamResult::exhausted();
        return StreamResult::exhausted(
            {.reason = Reason::kinematics,
             .message = "the hand has no grasp of '" + call.inputs[0].name() + "'"});
    }

    StreamResult placement(const StreamCall& call) const {
        const int moved = scene_.body(call.inputs[0]);
        const Area& where = scene_.area(call.inputs[1]);
        const std::string names = "'" + call.inputs[0].name() + "' in '" + where.name + "'";
        if (call.attempt >= scene_.scene().placements.count) return StreamResult::exhausted();
        const std::optional<Pose> pose =
            make_placement(*scene_.scene().world[moved].model, scene_.scene().world, where, call.attempt,
                           scene_.scene().placements);
        if (!pose) return StreamResult::reject({.message = "there is no room for " + names});
        if (!standing_.is_free(moved, *pose, movable_)) {
            return StreamResult::reject(
                {.reason = Reason::collision, .message = "no free place for " + names});
        }
        return StreamResult::sample({Value::of(*pose)});
    }

    StreamResult pick(const StreamCall& call) const {
        const int taken = scene_.body(call.inputs[0]);
        const World world = scene_.world_at(call.fluents).with_pose(taken, call.inputs[1].get<Pose>());
        return scene_.answer(
            call, manipulator_->pick(world, taken, call.inputs[2].get<Grasp>(), call.budget, call.attempt));
    }

    StreamResult place(const StreamCall& call) const {
        const int put = scene_.body(call.inputs[0]);
        return scene_.answer(
            call, manipulator_->place(scene_.world_at(call.fluents), put, call.inputs[2].get<Grasp>(),
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
        GraspOptions options = scene_.scene().grasps;
        const auto kinds = scene_.scene().grasp_kinds.find(body);
        if (kinds == scene_.scene().grasp_kinds.end()) return options;
        const auto has = [&](GraspKind kind) {
            return std::ranges::find(kinds->second, kind) != kinds->second.end();
        };
        options.top = options.top && has(GraspKind::top);
        options.side = options.side && has(GraspKind::side);
        return options;
    }

    SceneLookup scene_;
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
