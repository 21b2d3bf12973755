#include "practice/methods/ees_method.hpp"

#include <cmath>

namespace praxis::practice {

namespace {

constexpr double kLeastGain = 1e-6;  // nats
// Gains of plans are smaller than the success rates that the bonus was made for.
constexpr double kBonusShare = 0.3;

}  // namespace

double PublishedEesMethod::situate(std::span<Candidate> candidates) {
    if (candidates.empty()) return 0;
    std::vector<Improvement> improvements;
    for (const Candidate& candidate : candidates)
        improvements.push_back({candidate.skill, success_cost(candidate.predicted)});
    improvements.push_back({0, learner_->costs()[0]});
    const std::vector<double> costs =
        learner_->planner().expected_costs(situations(), learner_->costs(), improvements);
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].cost = costs[i];
    return costs.back();
}

void PublishedEesMethod::score(std::span<Candidate> candidates) {
    situate(candidates);
    for (Candidate& candidate : candidates) {
        const double cost = std::isinf(candidate.cost) ? 0 : candidate.cost;
        candidate.score = candidate.successes == candidate.tries ? kNever : candidate.bonus - cost;
    }
}

bool EesMethod::considers(SkillIndex skill) const {
    return !learner_->skills().schema(skill).parameters.empty();
}

void EesMethod::score(std::span<Candidate> candidates) {
    const double now = situate(candidates);
    for (Candidate& candidate : candidates)
        candidate.score =
            now - candidate.cost > kLeastGain ? kBonusShare * candidate.bonus - candidate.cost : kNever;
}

}  // namespace praxis::practice
