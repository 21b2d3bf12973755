// All that is known of taking a body by a grasp from where it stands; to put it there is the same backwards.
//
// From its target the open hand draws back on a straight line; and holding the body, it lifts it, in the
// first of a few ways. First the hand flies these lines alone; then the arm follows it, in one of several
// configurations (and, with a mobile base, from one of several places). What fails among the fixed bodies
// fails for good. Of movable bodies it is kept, one by one, what they stop.
#pragma once

#include <array>
#include <optional>
#include <unordered_map>

#include "tamp/manipulation/action_motion.hpp"
#include "tamp/geometry/axis_box.hpp"
#include "tamp/manipulation/skill_space.hpp"

namespace praxis::tamp {

/// What a body stops: bit 0 the target or the way back, bit 1 + i the i-th lift.
using Stops = std::uint8_t;
inline constexpr std::size_t kLifts = 3;
inline constexpr Stops kStopsAll = 1;
inline constexpr Stops stops_lift(std::size_t lift) {
    return static_cast<Stops>(2U << lift);
}

/// What one body stops, and how that shows.
struct Obstacle {
    Stops stops = 0;
    ActionFailure why = {};
};

/// A way of the arm to follow the hand.
struct Way {
    std::optional<ActionFailure> failure = {};  ///< whatever movable bodies stand
    Configuration arm = {};                     ///< at the target
    Path back = {};                             ///< from the target, with the open hand
    std::array<Path, kLifts> lifts = {};        ///< from the target, with the body; empty: not possible
    std::vector<AxisBox> boxes = {};            ///< around the arm without its hand, on all these paths
    std::unordered_map<SkillSpace::Id, Obstacle> obstacles = {};
    /// From home, among fixed bodies only, to the ends of `back` and of the lifts.
    std::optional<MotionResult> transit = {};
    std::array<std::optional<MotionResult>, kLifts> transfers = {};
};

/// Where the base stands.
struct Stance {
    SkillSpace::Id base = 0;
    Configuration positions = {};  ///< of the base; empty: the arm stands
    std::unordered_map<std::uint64_t, Way> ways = {};
};

class Site {
  public:
    Site(SkillSpace& space, int body, const Pose& pose, const Grasp& grasp);

    /// The hand alone cannot do it.
    const std::optional<ActionFailure>& failure() const { return failure_; }
    /// By lift: the hand alone can do it.
    const std::array<bool, kLifts>& lifts() const { return open_; }
    /// What a movable body stops of the hand.
    const Obstacle& stopped(int body, const Pose& pose, SkillSpace::Id standing);

    /// Where the base may stand; one that says nothing where the arm stands.
    std::vector<Stance>& stances();
    /// Number `number` of the ways; its failure says where there is none.
    Way& way(Stance& stance, std::uint64_t number);
    /// What a movable body stops of the arm.
    const Obstacle& stopped(const Stance& stance, Way& way, int body, const Pose& pose,
                            SkillSpace::Id standing);

    SkillSpace::Id standing() const { return standing_; }
    SkillSpace::Id held() const { return held_; }

  private:
    void check_hand();
    Path hand_path(std::span<const Vector3> legs) const;
    Way make_way(const Stance& stance, std::uint64_t number);
    void find_boxes(const Stance& stance, Way& way) const;

    SkillSpace& space_;
    int body_;
    Pose pose_;
    SkillSpace::Id standing_;
    SkillSpace::Id held_;
    Pose target_;                                            ///< of the tool
    Vector3 back_;                                           ///< the way back, a vector in the world
    std::array<std::vector<Vector3>, kLifts> legs_;          ///< of the lifts
    std::array<bool, kLifts> open_ = {};
    std::optional<ActionFailure> failure_ = {};
    Path hand_back_ = {};
    std::array<Path, kLifts> hand_lifts_ = {};
    AxisBox back_box_, lift_box_;  ///< around the hand, and the hand with the body, on their ways
    std::unordered_map<SkillSpace::Id, Obstacle> obstacles_ = {};
    std::vector<Stance> stances_ = {};
};

/// Every edge is free.
bool is_path_free(CollisionChecker& checker, const Path& path, bool certified);

}  // namespace praxis::tamp
