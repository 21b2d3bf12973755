#include "practice/loop/learner.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "practice/loop/simulated_world.hpp"

namespace praxis::practice {

namespace {

constexpr std::uint64_t kLearning = 3;
constexpr int kLookahead = 1;  // cycles
constexpr int kOutcomes = 10;  // that a cycle of practice is taken to bring

void require_finite(std::span<const double> numbers, const std::string& of) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!std::isfinite(numbers[i]))
            throw std::invalid_argument("the environment gives a number that is not finite: number " +
                                        std::to_string(i) + " of " + of);
    }
}

std::vector<std::int32_t> schemas_of(const SkillTask& skills) {
    std::vector<std::int32_t> schemas;
    for (SkillIndex i = 0; i < skills.size(); ++i) schemas.push_back(skills.skill(i).schema);
    return schemas;
}

}  // namespace

Learner::Learner(const Environment& environment, const PracticeOptions& options)
    : options_(options),
      skills_(environment),
      planner_(skills_, options.planner),
      test_planner_(skills_, options.planner),
      competences_(schemas_of(skills_), options.competence, options.sharing),
      random_(random_stream(options.seed, kLearning)) {
    for (const SkillSchema& schema : environment.description().schemas) {
        policies_.emplace_back();
        if (!schema.parameters.empty())
            policies_.back().emplace(schema.features.size(), schema.relevant_features,
                                     schema.parameters.size(), options.policy);
    }
    costs_.resize(skills_.size());
    for (SkillIndex skill = 0; skill < skills_.size(); ++skill) update_cost(skill);
}

void Learner::update_cost(SkillIndex skill) {
    costs_[skill] = success_cost(competences_.competence(skill));
}

double Learner::predicted(SkillIndex skill) const {
    return competences_.predict(skill, kOutcomes, kLookahead);
}

std::vector<double> Learner::features(SkillIndex skill, const State& state) const {
    std::vector<double> result(skills_.schema(skill).features.size());
    skills_.environment().features(state, skills_.skill(skill), result);
    require_finite(result, "the features of " + skills_.name(skill));
    return result;
}

Decision Learner::decide(SkillIndex skill, const State& state, Mode mode, Random& random) const {
    Decision decision{skill, {}, mode != Mode::base};
    const std::size_t dimension = skills_.schema(skill).parameters.size();
    if (dimension == 0) return decision;
    const std::size_t count = mode == Mode::base ? 1 : static_cast<std::size_t>(options_.policy.candidates);
    std::vector<double> candidates(count * dimension);
    for (std::size_t i = 0; i < count; ++i)
        skills_.environment().propose(state, skills_.skill(skill), random,
                                      std::span(candidates).subspan(i * dimension, dimension));
    std::size_t chosen = 0;
    if (mode != Mode::base) {
        const ParameterPolicy& policy = *policies_[static_cast<std::size_t>(skills_.skill(skill).schema)];
        const std::vector<double> seen = features(skill, state);
        if (mode == Mode::greedy) {
            chosen = policy.best(seen, candidates, random);
        } else {
            const ParameterPolicy::Choice choice = policy.explore(seen, candidates, random);
            chosen = choice.candidate;
            decision.greedy = choice.greedy;
        }
    }
    const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(chosen * dimension);
    decision.parameters.assign(first, first + static_cast<std::ptrdiff_t>(dimension));
    require_finite(decision.parameters, "the parameters proposed for " + skills_.name(skill));
    return decision;
}

Moment Learner::moment(const State& state) const {
    require_finite(state, "a state");
    Moment result{state, {}};
    skills_.read(state, result.values);
    return result;
}

bool Learner::observe(const Moment& before, const Decision& decision, const Moment& after) {
    const bool success = skills_.succeeded(decision.skill, before.values, after.values);
    ++transitions_;
    competences_.observe(decision.skill, success, decision.greedy);
    update_cost(decision.skill);
    auto& policy = policies_[static_cast<std::size_t>(skills_.skill(decision.skill).schema)];
    if (policy) policy->observe(features(decision.skill, before.state), decision.parameters, success);
    return success;
}

void Learner::learn() {
    for (auto& policy : policies_) {
        if (policy) policy->learn(random_);
    }
    competences_.advance_cycle();
    for (SkillIndex skill = 0; skill < skills_.size(); ++skill) update_cost(skill);
}

}  // namespace praxis::practice
