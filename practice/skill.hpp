// Skills: actions with continuous parameters, and what is known of them beforehand.
//
// A *skill schema* is an action schema of the PDDL domain together with a parameter space Theta, a box of
// numbers that the plan leaves open (grasp offset, force, ...). A *ground skill* is a ground operator: the
// schema with its objects. The options framework calls it (I, Theta, mu, beta, phi): initiation (the
// precondition), parameters, controller and termination (`World::execute`), success (the add effects hold
// afterwards). Parameters are chosen by a parameter policy, one a schema (`policies/`); how likely a ground
// skill succeeds under it is its *competence* (`competence/`).
//
// Source: Kumar et al., "Practice Makes Perfect: Planning to Learn Skill Parameter Policies", RSS 2024.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace praxis::practice {

/// What an environment knows of one action schema.
struct SkillSchema {
    std::string name;  ///< of the action in the PDDL domain
    /// One name a parameter; empty: there is nothing to choose, and nothing to learn.
    std::vector<std::string> parameters;
    /// One name a feature that `Environment::features` writes for this schema.
    std::vector<std::string> features;
    /// Which of the features success depends on, as an engineer who knows the skill would choose ("oracle"
    /// features).
    std::vector<std::size_t> relevant_features;
};

/// A schema with objects, both by their numbers in the environment's `Description`.
struct GroundSkill {
    std::int32_t schema = 0;
    std::vector<std::int32_t> objects;
    friend bool operator==(const GroundSkill&, const GroundSkill&) = default;
};

/// A ground atom, by the numbers of predicate and objects in the environment's `Description`.
struct GroundAtom {
    std::int32_t predicate = 0;
    std::vector<std::int32_t> objects;
    friend bool operator==(const GroundAtom&, const GroundAtom&) = default;
};

}  // namespace praxis::practice
