// What all environments here share: a description, checked calls, and skills that do nothing out of place.
//
// A derived class says which atoms hold, where a skill can start and what it does; the calls of
// `SimulatedEnvironment` arrive there with a state, a skill and spans of the right sizes and finite
// parameters.
#pragma once

#include <cstddef>

#include "practice/environment.hpp"

namespace praxis::practice {

class CheckedEnvironment : public SimulatedEnvironment {
  public:
    const Description& description() const final { return description_; }
    // All of these throw std::invalid_argument for sizes and numbers that do not fit the description.
    bool holds(const State& state, const GroundAtom& atom) const final;
    void propose(const State& state, const GroundSkill& skill, Random& random,
                 std::span<double> parameters) const final;
    void features(const State& state, const GroundSkill& skill, std::span<double> features) const final;
    /// Throws std::invalid_argument also for parameters that are not finite.
    void execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                 Random& random) const final;

  protected:
    /// The objects of one type: numbers first to last of the description.
    struct Range {
        std::int32_t first = 0;
        std::int32_t last = 0;
    };
    /// What the predicates and the schemas take, in their order in the description.
    struct Signatures {
        std::vector<std::vector<Range>> predicates;
        std::vector<std::vector<Range>> schemas;
    };
    CheckedEnvironment(Description description, Signatures signatures, std::size_t state_size);

    virtual bool atom_holds(const State& state, const GroundAtom& atom) const = 0;
    /// Whether the precondition of the skill holds.
    virtual bool can_start(const State& state, const GroundSkill& skill) const = 0;
    /// Only where the skill can start.
    virtual void act(State& state, const GroundSkill& skill, std::span<const double> parameters,
                     Random& random) const = 0;
    /// Only for skills with parameters.
    virtual void draw_parameters(const State& state, const GroundSkill& skill, Random& random,
                                 std::span<double> parameters) const = 0;
    /// Only for skills with features.
    virtual void write_features(const State& state, const GroundSkill& skill,
                                std::span<double> features) const = 0;

  private:
    void check(const State& state) const;
    const SkillSchema& checked_schema(const State& state, const GroundSkill& skill) const;

    Description description_;
    Signatures signatures_;
    std::size_t state_size_;
};

}  // namespace praxis::practice
