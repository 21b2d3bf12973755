// Environments whose skills succeed with stated probabilities.
//
// A skill with parameters has an optimum, which depends on features of the state; it succeeds with the
// probability that a `LogisticSuccess` gives for the parameters' Euclidean distance from it. Parameters are
// proposed uniformly in [-1, 1]; optima and features lie there too. A skill without parameters always
// succeeds.
#pragma once

#include "practice/environments/checked_environment.hpp"
#include "practice/environments/logistic_success.hpp"

namespace praxis::practice {

class StatedEnvironment : public CheckedEnvironment {
  public:
    using CheckedEnvironment::CheckedEnvironment;

    /// Of a skill where it can start. Throws std::invalid_argument for sizes that do not fit.
    double success_probability(const State& state, const GroundSkill& skill,
                               std::span<const double> parameters) const;
    /// The parameters that are most likely to succeed; all are where none matter.
    virtual void optimum(const State& state, const GroundSkill& skill,
                         std::span<double> parameters) const = 0;

  protected:
    /// Only for skills with parameters.
    virtual LogisticSuccess model(const State& state, const GroundSkill& skill) const = 0;
    virtual void succeed(State& state, const GroundSkill& skill, Random& random) const = 0;
    virtual void fail(State& state, const GroundSkill& skill, Random& random) const = 0;

    void act(State& state, const GroundSkill& skill, std::span<const double> parameters,
             Random& random) const final;
    void draw_parameters(const State& state, const GroundSkill& skill, Random& random,
                         std::span<double> parameters) const final;
};

}  // namespace praxis::practice
