// What a practising robot knows: how competent its skills are, and how to choose their parameters.
//
// Shared by all methods, so that they differ in what they practise and in nothing else. Greedy choices say
// what the robot would do in earnest; explored ones are for learning, and do not count for competence unless
// they were the greedy ones too.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "practice/competence/competences.hpp"
#include "practice/loop/options.hpp"
#include "practice/planning/cost_planner.hpp"
#include "practice/policies/parameter_policy.hpp"

namespace praxis::practice {

/// A skill with its parameters, to be executed.
struct Decision {
    SkillIndex skill = 0;
    std::vector<double> parameters;
    bool greedy = true;
};

/// A state, and what holds in it.
struct Moment {
    State state;
    std::vector<std::int32_t> values;
};

class Learner {
  public:
    /// `environment` must outlive this. Throws as SkillTask and the parts' constructors do.
    Learner(const Environment& environment, const PracticeOptions& options);

    const PracticeOptions& options() const { return options_; }
    const SkillTask& skills() const { return skills_; }
    const Competences& competences() const { return competences_; }
    CostPlanner& planner() { return planner_; }
    /// Another planner for tests, so that nothing that they plan changes which of equal plans practice finds.
    CostPlanner& test_planner() { return test_planner_; }
    Random& random() { return random_; }

    /// By skill, the cost of the present competence.
    std::span<const Cost> costs() const { return costs_; }
    /// The competence of a skill after one more cycle of practice.
    double predicted(SkillIndex skill) const;

    enum class Mode { greedy, explore, base };  ///< base: just what the base sampler proposes
    /// These throw std::invalid_argument where the environment gives numbers that are not finite.
    Decision decide(SkillIndex skill, const State& state, Mode mode, Random& random) const;
    Moment moment(const State& state) const;

    /// Takes in what came of a decision; whether the skill has succeeded.
    bool observe(const Moment& before, const Decision& decision, const Moment& after);
    /// Learns the parameter policies from all outcomes: a cycle ends.
    void learn();
    /// Every skill executed so far.
    std::int64_t transitions() const { return transitions_; }

  private:
    std::vector<double> features(SkillIndex skill, const State& state) const;
    void update_cost(SkillIndex skill);

    PracticeOptions options_;
    SkillTask skills_;
    CostPlanner planner_;
    CostPlanner test_planner_;
    Competences competences_;
    std::vector<std::optional<ParameterPolicy>> policies_;  // by schema; none where there are no parameters
    std::vector<Cost> costs_;
    Random random_;
    std::int64_t transitions_ = 0;
};

}  // namespace praxis::practice
