#include "practice/methods/simple_scores.hpp"

#include <algorithm>

namespace praxis::practice {

void FailFocusMethod::score(std::span<Candidate> candidates) {
    for (Candidate& candidate : candidates)
        candidate.score =
            1 - static_cast<double>(candidate.successes) / std::max(1, candidate.tries) + candidate.bonus;
}

void CompetenceGradientMethod::score(std::span<Candidate> candidates) {
    for (Candidate& candidate : candidates)
        candidate.score = candidate.predicted - candidate.competence + candidate.bonus;
}

void SkillDiversityMethod::score(std::span<Candidate> candidates) {
    for (Candidate& candidate : candidates) candidate.score = 1.0 / (1 + candidate.tries);
}

void TaskRelevantMethod::score(std::span<Candidate> candidates) {
    for (Candidate& candidate : candidates) candidate.score = uniform(learner_->random());
}

}  // namespace praxis::practice
