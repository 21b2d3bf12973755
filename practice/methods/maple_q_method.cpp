#include "practice/methods/maple_q_method.hpp"

#include <algorithm>

namespace praxis::practice {

namespace {

constexpr int kSamples = 5;  // of the parameters of each skill

}  // namespace

MapleQMethod::MapleQMethod(Learner& learner) : learner_(&learner) {}

void MapleQMethod::begin_task(const Situation& situation, bool test) {
    if (!test) goal_ = situation.goal;
}

std::vector<double> MapleQMethod::features(const State& state, const std::vector<Fact>& goal) const {
    std::vector<double> result = state;
    const std::size_t first = result.size();
    result.resize(first + learner_->skills().task().variable_count(), -1);
    for (const Fact& fact : goal) result[first + static_cast<std::size_t>(fact.variable)] = fact.value;
    return result;
}

std::vector<QFunction::Action> MapleQMethod::actions(const Moment& now, Random& random) const {
    std::vector<QFunction::Action> result;
    learner_->skills().for_each_applicable(now.values, [&](SkillIndex skill) {
        const int samples = learner_->skills().schema(skill).parameters.empty() ? 1 : kSamples;
        for (int i = 0; i < samples; ++i)
            result.push_back(
                {skill, learner_->decide(skill, now.state, Learner::Mode::base, random).parameters});
    });
    return result;
}

std::optional<Decision> MapleQMethod::best(const Moment& now, const std::vector<Fact>& goal,
                                           Random& random) const {
    const std::vector<QFunction::Action> choices = actions(now, random);
    if (choices.empty()) return std::nullopt;
    std::size_t chosen = random.below(choices.size());
    if (values_) {
        std::vector<double> values(choices.size());
        values_->values(features(now.state, goal), choices, values);
        const auto highest = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
        if (values[highest] > values[chosen]) chosen = highest;
    }
    return Decision{static_cast<SkillIndex>(choices[chosen].skill), choices[chosen].parameters, true};
}

std::optional<Decision> MapleQMethod::pursue(const Moment& now, const std::vector<Fact>& goal, Random& random,
                                             bool test) {
    return test ? best(now, goal, random) : practise(now);
}

std::optional<Decision> MapleQMethod::practise(const Moment& now) {
    Random& random = learner_->random();
    if (!all_hold(goal_, now.values.data()) && uniform(random) >= learner_->options().policy.epsilon)
        return best(now, goal_, random);
    std::vector<SkillIndex> applicable;
    learner_->skills().for_each_applicable(now.values, [&](SkillIndex i) { applicable.push_back(i); });
    if (applicable.empty()) return std::nullopt;
    return learner_->decide(applicable[random.below(applicable.size())], now.state, Learner::Mode::base,
                            random);
}

void MapleQMethod::observe(const Moment& before, const Decision& decision, const Moment& after, bool,
                           bool test) {
    if (test || all_hold(goal_, before.values.data())) return;
    if (!values_) {
        std::size_t parameters = 0;
        for (const SkillSchema& schema : learner_->skills().environment().description().schemas)
            parameters = std::max(parameters, schema.parameters.size());
        values_.emplace(features(before.state, goal_).size(), learner_->skills().size(), parameters);
    }
    const bool reached = all_hold(goal_, after.values.data());
    values_->add({.features = features(before.state, goal_),
                  .action = {decision.skill, decision.parameters},
                  .reward = reached ? 1.0 : 0.0,
                  .next_features = features(after.state, goal_),
                  .next_actions = actions(after, learner_->random()),
                  .terminal = reached});
}

void MapleQMethod::learned() {
    if (values_) values_->learn(learner_->random());
}

}  // namespace praxis::practice
