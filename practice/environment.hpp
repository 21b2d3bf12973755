// Where skills are practised: what a robot's program, or a simulator, tells the practice loop.
//
// An `Environment` is knowledge without a state of its own: the PDDL domain, which atoms hold in a state,
// where parameters are proposed, which features a parameter policy may look at. A `World` acts: it has one
// true state, and nothing resets it unless its owner does. A `SimulatedEnvironment` can also draw tasks and
// simulate skills; `SimulatedWorld` makes a world of it. A robot's program implements `Environment` and
// `World`.
//
// A *state* is a flat list of numbers that only the environment understands (poses, levels, which hand holds
// what), all of one length. Environments are immutable and may be used from several threads at once.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "practice/skill.hpp"
#include "search/engines/random.hpp"

namespace praxis::practice {

using State = std::vector<double>;

/// What is fixed about an environment.
struct Description {
    std::string name;
    std::string domain;  ///< PDDL text; each action is a skill schema
    std::string
        problem;  ///< PDDL text with all objects and static atoms; its initial state and goal are one task's
    std::vector<std::string> predicates;  ///< fluent ones; names as in the domain
    std::vector<std::string> objects;     ///< constants too; names as in the domain and the problem
    std::vector<SkillSchema> schemas;
    int horizon = 0;      ///< skills that one task may take
    int cycle_steps = 0;  ///< skills that one cycle of practice usually takes
};

/// What is asked of the robot: from this state, make all these atoms true.
struct PracticeTask {
    State initial;
    std::vector<GroundAtom> goal;
};

class Environment {
  public:
    virtual ~Environment() = default;
    virtual const Description& description() const = 0;

    /// Whether a (fluent) atom holds in a state. All atoms of the ground task are asked, also odd ones.
    virtual bool holds(const State& state, const GroundAtom& atom) const = 0;
    /// Proposes parameters by the base sampler that is known beforehand; `parameters` has the schema's
    /// dimension.
    virtual void propose(const State& state, const GroundSkill& skill, Random& random,
                         std::span<double> parameters) const = 0;
    /// Writes the features of a state for a ground skill; `features` has the schema's number of them.
    virtual void features(const State& state, const GroundSkill& skill, std::span<double> features) const = 0;
};

class SimulatedEnvironment : public Environment {
  public:
    /// Draws a task of the task distribution.
    virtual PracticeTask sample_task(Random& random) const = 0;
    /// What the skill does to the state, from the precondition on; where the precondition does not hold,
    /// nothing. `parameters` may be any finite numbers.
    virtual void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                         Random& random) const = 0;
};

/// Has a true state, is given tasks, and acts.
class World {
  public:
    virtual ~World() = default;
    /// The robot is given its next task: what is to be true. Whether the state changes with that (somebody
    /// tidied up) is the world's affair.
    virtual std::vector<GroundAtom> next_task() = 0;
    /// The state as it is now.
    virtual const State& observe() = 0;
    /// Runs the skill to its end, whatever comes of it.
    virtual void execute(const GroundSkill& skill, std::span<const double> parameters) = 0;
    /// A run is taken up from a journal that ends in this state, after so many skills and tasks. A real world
    /// is where it is; a simulated one puts itself there.
    virtual void resume(const State& /*state*/, std::uint64_t /*skills*/, std::uint64_t /*tasks*/) {}
};

/// In [0, 1).
inline double uniform(Random& random) {
    return static_cast<double>(random.next() >> 11) * 0x1.0p-53;
}
/// In [low, high).
inline double uniform(Random& random, double low, double high) {
    return low + (high - low) * uniform(random);
}

}  // namespace praxis::practice
