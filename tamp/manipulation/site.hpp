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
#include <unordered_set>

#include "tamp/manipulation/action_motion.hpp"
#include "tamp/geometry/axis_box.hpp"
#include "tamp/manipulation/skill_space.hpp"

namespace praxis::tamp {

inline constexpr std::size_t kLifts = 3;

/// Which parts of a way one body stops: the target and the way back (part 0), and the lifts (from part 1 on);
/// found out where it is asked for.
struct Obstacle {
    bool far = false;  ///< it stops nothing
    std::array<std::optional<bool>, 1 + kLifts> stops = {};
    ActionFailure why = {};  ///< of the first part that it stops
};

/// A path of the arm from home, found among fixed bodies only.
struct KnownPath {
    MotionResult found = {};
    std::unordered_set<SkillSpace::Id> free_of = {};  ///< movable bodies that it is known not to touch
};

/// A way of the arm to follow the hand.
struct Way {
    std::optional<ActionFailure> failure = {};  ///< whatever movable bodies stand
    std::optional<ActionFailure> stuck = {};    ///< why a lift was not possible
    Configuration arm = {};                     ///< at the target
    Path back = {};                             ///< from the target, with the open hand
    std::array<std::optional<Path>, kLifts> lifts = {};  ///< from the target, with the body; empty: not possible
    std::vector<AxisBox> boxes = {};            ///< around the arm without its hand, on all these paths
    std::unordered_map<SkillSpace::Id, Obstacle> obstacles = {};
    /// To the ends of `back` and of the lifts.
    std::optional<KnownPath> transit = {};
    std::array<std::optional<KnownPath>, kLifts> transfers = {};
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
    /// The hand alone can do this lift.
    bool can_lift(std::size_t lift);
    /// Whether a movable body is where the hand, or what it holds, passes by.
    bool is_near(int body, const Pose& pose) const;
    /// How a movable body stops this part of the hand's way; null: it does not.
    const ActionFailure* stopped(std::size_t part, int body, const Pose& pose, SkillSpace::Id standing);

    /// Where the base may stand; one that says nothing where the arm stands.
    std::vector<Stance>& stances();
    /// Number `number` of the ways; its failure says where there is none.
    Way& way(Stance& stance, std::uint64_t number);
    /// The arm's path of a lift that the hand can do; empty: not possible, which is then the way's failure if no
    /// lift is.
    const Path& lift(const Stance& stance, Way& way, std::size_t lift);
    /// How a movable body stops this part of the arm's way; null: it does not.
    const ActionFailure* stopped(std::size_t part, const Stance& stance, Way& way, int body, const Pose& pose,
                                 SkillSpace::Id standing);

    SkillSpace::Id standing() const { return standing_; }
    SkillSpace::Id held() const { return held_; }

  private:
    void check_hand();
    Path hand_path(std::span<const Vector3> legs) const;
    Way make_way(const Stance& stance, std::uint64_t number);
    void add_boxes(const Stance& stance, Way& way, const Path& path) const;
    const ActionFailure* decide(Obstacle& obstacle, std::size_t part, const ProbeOf& probe, const Path& path,
                                const std::string& phase);

    SkillSpace& space_;
    int body_;
    Pose pose_;
    SkillSpace::Id standing_;
    SkillSpace::Id held_;
    Pose target_;                                            ///< of the tool
    Vector3 back_;                                           ///< the way back, a vector in the world
    std::array<std::vector<Vector3>, kLifts> legs_;          ///< of the lifts
    std::array<std::optional<bool>, kLifts> open_ = {};
    std::optional<ActionFailure> failure_ = {};
    Path hand_back_ = {};
    std::array<Path, kLifts> hand_lifts_ = {};
    AxisBox box_;  ///< around the hand with the body, on all their ways
    std::unordered_map<SkillSpace::Id, Obstacle> obstacles_ = {};
    std::vector<Stance> stances_ = {};
};

/// Every edge is free.
bool is_path_free(CollisionChecker& checker, const Path& path, bool certified);

}  // namespace praxis::tamp
