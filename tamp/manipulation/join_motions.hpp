// Takes the ways home out of a plan: where one action ends and the next begins, the robot goes straight on.
#pragma once

#include <vector>

#include "search/budget.hpp"
#include "tamp/manipulation/manipulator.hpp"

namespace praxis::tamp {

/// `motions` lead from home to home, one after the other, from `world` on. Where a direct motion is found and
/// shorter, it takes the place of the two ways home; else these stay. The last way home stays.
std::vector<ActionMotion> join_motions(const Manipulator& manipulator, const World& world,
                                       std::vector<ActionMotion> motions, const Budget& budget = {});

}  // namespace praxis::tamp
