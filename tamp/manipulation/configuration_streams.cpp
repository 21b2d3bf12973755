#include "tamp/manipulation/configuration_streams.hpp"

#include <algorithm>
#include <array>

#include "tamp/collision/body_checker.hpp"
#include "tamp/manipulation/failure_log.hpp"
#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/manipulation/scene_lookup.hpp"
#include "tamp/manipulation/site.hpp"
#include "tamp/sampling/base_poses.hpp"

namespace praxis::tamp {

namespace {

using Kind = TrajectoryDocument::Motion;
using FailureReason = TrajectoryDocument::Reason;

Path reversed(Path path) {
    std::ranges::reverse(path);
    return path;
}

class Configurations {
  public:
    Configurations(std::shared_ptr<const PickPlaceScene> scene,
                   std::shared_ptr<const Manipulator> manipulator)
        : scene_(std::move(scene)),
          manipulator_(std::move(manipulator)),
          model_(manipulator_->model()),
          fixed_(std::make_shared<const World>(fixed_part(scene_.scene().world))) {}

    std::uint32_t arm_configurations() const {
        return static_cast<std::uint32_t>(model_.options.arm_configurations);
    }
    std::uint32_t base_poses() const { return static_cast<std::uint32_t>(model_.options.base_poses); }

    /// The configuration `at` with its arm before the body.
    StreamResult kinematics(const StreamCall& call, const Configuration& at) const {
        const std::string what = "the arm does not reach '" + call.inputs[0].name() + "' so";
        if (call.attempt >= arm_configurations()) return StreamResult::exhausted();
        const std::optional<Path> back =
            way_back(call.inputs[1].get<Pose>(), call.inputs[2].get<Grasp>(), at, call.attempt);
        if (!back) return StreamResult::reject({.reason = Reason::kinematics, .message = what});
        const auto checker = model_.checker(fixed_, model_.arm, at);
        if (!is_path_free(*checker, *back, model_.options.certified)) {
            const ActionFailure why = contact_on_path(*checker, *back, "the approach");
            return StreamResult::reject({.reason = Reason::collision, .message = why.message});
        }
        Configuration result = at;
        model_.robot->insert(model_.group(model_.arm), back->back(), result);
        return StreamResult::sample({Value::of(std::move(result))});
    }

    StreamResult base(const StreamCall& call) const {
        if (model_.base < 0) throw std::invalid_argument("the robot has no mobile base");
        const BasePoseOptions ring{model_.options.base_nearest, model_.options.base_furthest,
                                   model_.options.base_poses};
        const Group& group = model_.group(model_.base);
        const std::vector<Configuration> poses = make_base_poses(
            call.inputs[1].get<Pose>().translation(), model_.robot->extract(group, model_.home), ring);
        if (call.attempt >= poses.size()) return StreamResult::exhausted();
        const auto checker = model_.checker(fixed_, model_.base, model_.home);
        const Configuration& pose = poses[call.attempt];
        if (!model_.robot->within_limits(group, pose) || !checker->is_free(pose))
            return StreamResult::reject(
                {.reason = Reason::collision, .message = "the base cannot stand there"});
        Configuration result = model_.home;
        model_.robot->insert(group, pose, result);
        return StreamResult::sample({Value::of(std::move(result))});
    }

    /// With `held` in the hand, or nothing.
    StreamResult travel(const StreamCall& call, bool holding) const {
        Configuration from = call.inputs[0].get<Configuration>();
        Configuration to = call.inputs[1].get<Configuration>();
        World world = scene_.world_at(call.fluents);
        if (holding) {
            const Grasp& grasp = call.inputs[3].get<Grasp>();
            world = world.with_attached(scene_.body(call.inputs[2]), model_.hold(grasp));
            close(grasp, from);
            close(grasp, to);
        }
        return scene_.answer(call, travel(from, to, std::make_shared<const World>(std::move(world)),
                                          holding ? Kind::transfer : Kind::transit, call));
    }

    /// To the body and back with it; `release`: to where it is put, and back without it.
    StreamResult handle(const StreamCall& call, bool release) const {
        const int body = scene_.body(call.inputs[0]);
        const Pose& pose = call.inputs[1].get<Pose>();
        const Grasp& grasp = call.inputs[2].get<Grasp>();
        const Configuration open = call.inputs[3].get<Configuration>();
        Configuration closed = open;
        close(grasp, closed);
        const Configuration before = model_.robot->extract(model_.group(model_.arm), open);
        const Vector3 along = model_.options.approach * model_.tool(open).linear().col(2);
        const std::optional<Path> there = model_.straight(open, before, std::span(&along, 1));
        if (!there)
            return scene_.answer(call, {.failure = {.reason = FailureReason::kinematics,
                                                    .message = "the arm cannot go straight to the grasp"}});
        const World at = scene_.world_at(call.fluents);
        const auto standing = std::make_shared<const World>(at.with_pose(body, pose));
        const auto held = std::make_shared<const World>(at.with_attached(body, model_.hold(grasp)));
        for (const bool laden : {release, !release}) {
            const auto checker = model_.checker(laden ? held : standing, model_.arm, laden ? closed : open);
            if (is_path_free(*checker, *there, model_.options.certified)) continue;
            return scene_.answer(call, blocked(*checker, *there, release ? "the way down" : "the approach"));
        }
        ActionMotion motion;
        const auto fingers = [&](const Configuration& now, const Configuration& then) {
            if (model_.gripper < 0 || now == then) return;
            const Group& group = model_.group(model_.gripper);
            motion.pieces.push_back(
                {.kind = Kind::gripper,
                 .group = model_.gripper,
                 .path = {model_.robot->extract(group, now), model_.robot->extract(group, then)}});
        };
        MotionPiece event{.kind = Kind::gripper, .group = model_.arm};
        motion.pieces.push_back({.kind = Kind::approach, .group = model_.arm, .path = *there});
        if (release) {
            event.detach = {{body, pose}};
            motion.pieces.push_back(std::move(event));
            fingers(closed, open);
        } else {
            fingers(open, closed);
            event.attach = {{body, model_.hold(grasp)}};
            motion.pieces.push_back(std::move(event));
        }
        motion.pieces.push_back({.kind = Kind::retreat, .group = model_.arm, .path = reversed(*there)});
        return StreamResult::sample({Value::of(std::move(motion))});
    }

    StreamResult clear(const StreamCall& call) const {
        const int moved = scene_.body(call.inputs[0]);
        const int other = scene_.body(call.inputs[2]);
        World world = scene_.scene().world;
        std::vector<int> ignored;
        for (int i = 0; i < static_cast<int>(world.size()); ++i)
            if (i != other) ignored.push_back(i);
        const BodyChecker checker(
            std::make_shared<const World>(world.with_pose(other, call.inputs[3].get<Pose>())));
        if (moved == other || checker.is_free(moved, call.inputs[1].get<Pose>(), ignored))
            return StreamResult::pass();
        return StreamResult::reject(
            {.reason = Reason::collision,
             .message = "'" + call.inputs[0].name() + "' would touch '" + call.inputs[2].name() + "'"});
    }

    const Configuration& home() const { return model_.home; }

  private:
    static World fixed_part(const World& world) {
        World fixed;
        for (const BodyState& body : world.bodies())
            if (!body.model->movable && !body.attachment) fixed = fixed.with_body(body.model, body.pose);
        return fixed;
    }

    void close(const Grasp& grasp, Configuration& configuration) const {
        if (model_.gripper < 0) return;
        model_.robot->insert(model_.group(model_.gripper), model_.fingers(ManipulatorModel::grip(grasp)),
                             configuration);
    }

    /// Of the arm, from the grasp to before the body.
    std::optional<Path> way_back(const Pose& pose, const Grasp& grasp, const Configuration& at,
                                 std::uint64_t number) const {
        const Pose target = pose * grasp.body_in_tool.inverse();
        const std::optional<Configuration> arm = model_.reach(at, target, number);
        if (!arm) return std::nullopt;
        const Vector3 back = -model_.options.approach * target.linear().col(2);
        return model_.straight(at, *arm, std::span(&back, 1));
    }

    ActionResult travel(const Configuration& from, const Configuration& to, const WorldPointer& world,
                        Kind kind, const StreamCall& call) const {
        ActionMotion motion;
        Configuration now = from;
        // A base drives with its arm folded.
        const bool drives = model_.base >= 0 && !same(model_.base, from, to);
        const std::array<std::pair<int, const Configuration*>, 3> legs = {
            {{model_.arm, &model_.home}, {model_.base, &to}, {model_.arm, &to}}};
        for (std::size_t i = drives ? 0 : 2; i < legs.size(); ++i) {
            const auto [group, goal] = legs[i];
            if (same(group, now, *goal)) continue;
            const Configuration begin = model_.robot->extract(model_.group(group), now);
            const Configuration end = model_.robot->extract(model_.group(group), *goal);
            const auto checker = model_.checker(world, group, now);
            MotionResult found = model_.travel(*checker, begin, end, call.attempt, call.budget);
            if (found.status != MotionStatus::solved) return no_path(*checker, begin, end, found);
            motion.pieces.push_back({.kind = group == model_.base ? Kind::base : kind,
                                     .group = group,
                                     .path = std::move(found.path)});
            model_.robot->insert(model_.group(group), end, now);
        }
        return {.motion = std::move(motion)};
    }

    bool same(int group, const Configuration& first, const Configuration& second) const {
        return model_.robot->extract(model_.group(group), first) ==
               model_.robot->extract(model_.group(group), second);
    }

    ActionResult no_path(CollisionChecker& checker, const Configuration& begin, const Configuration& end,
                         const MotionResult& found) const {
        if (found.status == MotionStatus::start_in_collision) return blocked(checker, {begin}, "the start");
        if (found.status == MotionStatus::goal_in_collision) return blocked(checker, {end}, "the goal");
        FailureLog log("go there");
        ActionFailure why{.reason = FailureReason::no_path, .message = "no path found", .definite = false};
        std::vector<int> bodies;
        for (const Obstruction& met : found.obstructions)
            if (met.who.kind == Participant::Kind::body && is_movable(met.who.index))
                bodies.push_back(met.who.index);
        log.add_no_path(bodies, why);
        return {.failure = log.take()};
    }

    /// A path that is not free: any one of the movable bodies at its first contact is to blame.
    ActionResult blocked(CollisionChecker& checker, const Path& path, const std::string& phase) const {
        FailureLog log("go there");
        const ActionFailure why = contact_on_path(checker, path, phase);
        std::vector<int> bodies;
        bool fixed = why.contacts.empty();
        for (const Contact& contact : why.contacts) {
            const std::size_t before = bodies.size();
            for (const Participant& who : {contact.first, contact.second})
                if (who.kind == Participant::Kind::body && is_movable(who.index) &&
                    !(*checker.problem().world)[who.index].attachment)
                    bodies.push_back(who.index);
            fixed = fixed || bodies.size() == before;
        }
        if (fixed)
            log.add_fixed(why);
        else
            log.add_blocked(std::move(bodies), why);
        return {.failure = log.take()};
    }

    bool is_movable(int body) const { return scene_.scene().world[body].model->movable; }

    SceneLookup scene_;
    std::shared_ptr<const Manipulator> manipulator_;
    const ManipulatorModel& model_;
    WorldPointer fixed_;  ///< what cannot be moved
};

}  // namespace

double motion_length(const ActionMotion& motion) {
    double length = 0;
    for (const MotionPiece& piece : motion.pieces)
        if (!piece.path.empty()) length += path_length(piece.path);
    return length;
}

void bind_configurations(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene,
                         std::shared_ptr<const Manipulator> manipulator) {
    constexpr std::uint32_t kMotionTries = 3;
    const auto streams = std::make_shared<const Configurations>(std::move(scene), std::move(manipulator));
    const StreamInfo solver{.effort = 100, .max_attempts = streams->arm_configurations() + 1};
    library.bind(
        "inverse-kinematics",
        [streams](StreamCall& call) { return streams->kinematics(call, streams->home()); }, solver);
    library.bind(
        "inverse-kinematics-at",
        [streams](StreamCall& call) {
            return streams->kinematics(call, call.inputs[3].get<Configuration>());
        },
        solver);
    library.bind("sample-base", [streams](StreamCall& call) { return streams->base(call); },
                 {.effort = 50, .max_attempts = streams->base_poses() + 1});
    library.bind("test-clear", [streams](StreamCall& call) { return streams->clear(call); }, {.effort = 20});
    const StreamInfo motion{.effort = 1000, .max_samples = 1, .max_attempts = kMotionTries};
    library.bind(
        "plan-free-motion", [streams](StreamCall& call) { return streams->travel(call, false); }, motion);
    library.bind(
        "plan-holding-motion", [streams](StreamCall& call) { return streams->travel(call, true); }, motion);
    const StreamInfo line{.effort = 200, .max_samples = 1, .max_attempts = 1};
    library.bind(
        "plan-grasp", [streams](StreamCall& call) { return streams->handle(call, false); }, line);
    library.bind(
        "plan-release", [streams](StreamCall& call) { return streams->handle(call, true); }, line);
    library.bind_function("motion-length", [](std::span<const Value> inputs) {
        return motion_length(inputs[0].get<ActionMotion>());
    });
}

}  // namespace praxis::tamp
