// Contingent tasks for the tests: from text, and random ones.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "belief/belief_task.hpp"
#include "belief/compilation.hpp"

namespace praxis::belief::testing {

struct Texts {
    std::string domain;
    std::string problem;
};

std::shared_ptr<const BeliefTask> ground(const Texts& texts);

/// Grounds `random_task(seed)`; nothing if the goal is out of reach even if everything were known.
std::shared_ptr<const BeliefTask> ground_random(const Texts& texts);

/// A few propositions, some of them unknown or one of several, actions with conditional effects and costs,
/// actions and sensors that observe. Many have no plan.
Texts random_task(std::uint64_t seed);

/// A corridor of doors: in each of `columns` columns one of three doors is open, which is seen from in front
/// of it, by an action or by a sensor.
Texts corridor(int columns, bool sensor = false);

}  // namespace praxis::belief::testing
