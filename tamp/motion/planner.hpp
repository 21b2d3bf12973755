// Motions of one group from a start to one of several goals: RRT-Connect, shortcuts, certification.
//
// By default the path is *certified*: every edge has passed `CollisionChecker::is_motion_certified`, which
// with the fast checker holds between the configurations that were looked at, too. Uncertified paths are
// checked at `step` alone; they take less time, and some percent of them touch something on the way.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "search/budget.hpp"
#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

enum class MotionStatus : std::uint8_t {
    solved,
    start_in_collision,
    goal_in_collision,  ///< every goal
    start_out_of_limits,
    goal_out_of_limits,  ///< every goal is out of limits or in collision, and at least one out of limits
    not_found            ///< iterations or budget ran out
};

/// Such as "goal in collision".
std::string_view to_string(MotionStatus status);

struct MotionOptions {
    std::uint64_t seed = 0;
    double step = kCheckStep;
    double range = 1;  ///< longest edge of the trees
    bool certified = true;
    bool shorten = true;
    int max_iterations = 100000;
    Budget budget = {};
};

/// Who was in the way of how many motions that were tried.
struct Obstruction {
    Participant who;
    int count = 0;
};

struct MotionResult {
    MotionStatus status = MotionStatus::not_found;
    Path path = {};  ///< with continuous variables running on without jumps (see rrt_connect.hpp)
    int goal = -1;   ///< which one the path ends at
    std::vector<Contact> contacts = {};  ///< of the start or the first goal in collision
    /// If no path was found: bodies in the way (and links, where the robot itself was), most frequent first.
    std::vector<Obstruction> obstructions = {};
    int iterations = 0;
    int nodes = 0;
};

/// Start and goals are positions of the checker's group. Throws std::invalid_argument for other lengths and
/// for numbers that are not finite.
MotionResult plan_motion(CollisionChecker& checker, std::span<const double> start,
                         std::span<const Configuration> goals, const MotionOptions& options = {});

}  // namespace praxis::tamp
