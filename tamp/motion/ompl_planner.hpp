// Motions by the planners of OMPL (the Open Motion Planning Library), for comparison and for what our own
// planner does not do: optimising planners, roadmaps, planners for narrow or high-dimensional spaces.
//
// The space is that of the checker's group: bounded variables, and angles without limits as circles, so that
// a base of x, y and yaw is SE(2). States and motions are checked by the checker alone. Left out are OMPL's
// planners that check from several threads (a checker belongs to one), those that never end by themselves
// (LBTRRT, LazyLBTRRT), SST, which does not arrive at a goal exactly, and those that need more than a space.
//
// OMPL has one source of random numbers for the process: `seed_ompl` sets it, before the first plan, once.
// Its messages are switched off at the first plan.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "search/budget.hpp"
#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

/// Names that `plan_with_ompl` knows, as OMPL's classes are called, sorted.
const std::vector<std::string>& ompl_planner_names();

/// Seeds OMPL's random numbers; OMPL heeds only the first seed, and none once it has drawn numbers. False if
/// this was not the first call. `seed` > 0.
bool seed_ompl(std::uint32_t seed);

struct OmplOptions {
    std::string planner = "RRTConnect";
    double step = kCheckStep;
    /// Longest extension of a tree, in the space's distance: Euclidean over bounded variables plus
    /// `turning_weight` times the angle for each without limits. 0: OMPL chooses.
    double range = 0;
    double turning_weight = 0.5;
    /// Spend the whole budget on a shorter path, where the planner can; else the first path is taken.
    bool improve = false;
    Budget budget = {};  ///< unlimited: a planner without an end of its own goes on until it finds a path
};

enum class OmplStatus : std::uint8_t {
    solved,
    start_invalid,  ///< out of limits or in collision
    goals_invalid,  ///< all of them, out of limits or in collision
    not_found,      ///< the planner gave up
    out_of_budget,
};

struct OmplResult {
    OmplStatus status = OmplStatus::not_found;
    Path path = {};             ///< from `start` itself; angles without limits run on without jumps
    int goal = -1;              ///< which one the path ends at
    std::uint64_t states = 0;   ///< checked
    std::uint64_t motions = 0;  ///< checked
};

/// From `start` to one of `goals`, positions of the checker's group. Throws std::invalid_argument for an
/// unknown planner (with a suggestion), positions of the wrong size or not finite, a slide without limits,
/// and options out of range.
OmplResult plan_with_ompl(CollisionChecker& checker, std::span<const double> start,
                          std::span<const Configuration> goals, const OmplOptions& options = {});

}  // namespace praxis::tamp
