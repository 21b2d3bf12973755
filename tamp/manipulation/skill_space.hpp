// Collision checkers for skills, over what does not move and over movable bodies one by one, and kept.
//
// Whether a motion is free of a set of bodies is whether it is free of each; so what was found out about one
// body at one pose holds in every world in which it stands there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>

#include "tamp/collision/solid.hpp"
#include "tamp/manipulation/action_motion.hpp"
#include "tamp/manipulation/flying_hand.hpp"
#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/refine/tuple_map.hpp"

namespace praxis::tamp {

class Drives;

/// Who may be touched, and by what of the robot.
enum class Probe : std::uint8_t {
    open_arm,      ///< arm and open hand; fixed bodies, and the body where it stands (the hand may touch it)
    passing_arm,   ///< the same; the hand may not touch the body
    holding_arm,   ///< arm and hand with the body; fixed bodies
    bare_arm,      ///< the arm without its hand; one movable body
    open_hand,     ///< the open hand alone; fixed bodies
    open_hand_at,  ///< the same; one movable body
    holding_hand,  ///< the hand with a body; fixed bodies
    holding_hand_at  ///< the same; one movable body
};

/// What a checker is for. `standing`, `held` and `base` mean something where the probe has them.
struct ProbeOf {
    using Id = std::uint32_t;
    Probe probe = Probe::open_hand;
    Id standing = 0;
    Id held = 0;
    Id base = 0;
};

class SkillSpace {
  public:
    using Id = ProbeOf::Id;

    /// `world`: its bodies that are movable are left out. Keeps a reference to the model.
    SkillSpace(const ManipulatorModel& model, const World& world);
    ~SkillSpace();

    const ManipulatorModel& model() const { return model_; }
    const FlyingHand& hand() const { return hand_; }
    /// Whether the fixed bodies of `world` are those of this space, at the same poses.
    bool matches(const World& world) const;

    /// Numbers of what was seen: a body that stands somewhere, a body that is held, positions of the base.
    Id standing(int body, const Pose& pose);
    Id held(int body, const Grasp& grasp);
    Id base(const Configuration& positions);

    /// Of a flying hand: its group; of an arm: its group.
    std::shared_ptr<CollisionChecker> checker(const ProbeOf& probe);
    /// The first contact on a path that is not free: "PHASE is in collision: ..."; not definite where none
    /// shows. Contacts are of the whole robot and the given world; there is no configuration of a hand alone.
    ActionFailure explain(const ProbeOf& probe, const Path& path, const std::string& phase);
    /// Whether two movable bodies touch where they stand.
    bool touch(int first, const Pose& first_pose, int second, const Pose& second_pose) const;
    /// Whether the open hand gets to the body by this grasp, and back, without touching it.
    bool fits(Id held);
    /// Whether the robot can hold the body by this grasp at home, among fixed bodies.
    bool can_carry(Id held);
    /// The robot, with the open hand or holding a body, among some that stand and no others.
    std::unique_ptr<CollisionChecker> checker_among(std::span<const Id> standing, std::optional<Id> held,
                                                    Id base) const;
    /// What is known of the drives of a mobile base.
    Drives& drives();
    /// Of a mobile base, the arm at home: among the fixed bodies, or with one that stands, alone.
    std::unique_ptr<CollisionChecker> base_checker(std::optional<Id> standing, std::optional<Id> held) const;
    /// Around a movable body: where it stands, and in the frame of the tool that holds it.
    Ball standing_bound(Id standing) const;
    Ball held_bound(Id held) const;
    /// Around all bodies, as they stood in the world that was given.
    AxisBox extent() const;
    /// The robot at home, its base at `base`, the fingers open or around what is held.
    Configuration home(Id base) const;
    Configuration home(Id base, Id held) const;
    const BodyModel& body(int number) const { return *world_[number].model; }
    const Robot& bare_arm() const { return *bare_arm_; }

  private:
    struct Standing {
        int body = 0;
        Pose pose = Pose::Identity();
    };
    struct Held {
        int body = 0;
        Grasp grasp = {};
        std::optional<bool> fits = {};
        std::optional<bool> can_carry = {};
    };
    std::shared_ptr<CollisionChecker> make(const ProbeOf& probe) const;
    /// Numbers, in the given world, of the bodies of a probe's world.
    std::vector<int> bodies_of(const ProbeOf& probe) const;
    Id number(std::string key, std::size_t next);

    const ManipulatorModel& model_;
    World world_;  ///< as it was given
    std::vector<int> fixed_;
    std::vector<std::vector<Solid>> solids_;  ///< of movable bodies, by body
    FlyingHand hand_;
    std::vector<int> all_links_;
    std::shared_ptr<const Robot> bare_arm_;
    std::vector<Standing> standing_;
    std::vector<Held> held_;
    std::vector<Configuration> bases_;
    std::unordered_map<std::string, Id> numbers_;
    TupleMap<std::shared_ptr<CollisionChecker>> checkers_;
    std::unique_ptr<Drives> drives_;  ///< made when they are first asked for
};

}  // namespace praxis::tamp
