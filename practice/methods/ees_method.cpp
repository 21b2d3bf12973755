#include "practice/methods/ees_method.hpp"

#include <cmath>
#include <limits>

namespace praxis::practice {

void EesMethod::score(std::span<Candidate> candidates) {
    std::vector<Improvement> improvements;
    for (const Candidate& candidate : candidates)
        improvements.push_back({candidate.skill, success_cost(candidate.predicted)});
    const std::vector<double> costs =
        learner_->planner().expected_costs(situations(), learner_->costs(), improvements);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        Candidate& candidate = candidates[i];
        candidate.cost = costs[i];
        const bool perfect = candidate.tries > 0 && candidate.successes == candidate.tries;
        candidate.score = perfect                ? -std::numeric_limits<double>::infinity()
                          : std::isinf(costs[i]) ? candidate.bonus
                                                 : candidate.bonus - costs[i];
    }
}

}  // namespace praxis::practice
