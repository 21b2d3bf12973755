#include "practice/methods/scored_method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace praxis::practice {

bool ScoredMethod::considers(SkillIndex skill) const {
    return learner_->options().candidates == "all" || learner_->competences().tries(skill) > 0;
}

void ScoredMethod::choose() {
    const Competences& competences = learner_->competences();
    ranking_.clear();
    double tries = 0;
    for (SkillIndex skill = 0; skill < learner_->skills().size(); ++skill) {
        Candidate candidate;
        candidate.skill = skill;
        candidate.tries = static_cast<int>(competences.tries(skill));
        candidate.successes = static_cast<int>(competences.successes(skill));
        tries += candidate.tries;
        if (!considers(skill)) continue;
        candidate.competence = competences.competence(skill);
        candidate.predicted = learner_->predicted(skill);
        ranking_.push_back(candidate);
    }
    for (Candidate& candidate : ranking_)
        candidate.bonus = learner_->options().bonus *
                          std::sqrt(std::log(std::max(1.0, tries)) / std::max(1, candidate.tries));
    learner_->random().shuffle(ranking_);
    score(ranking_);
    std::stable_sort(ranking_.begin(), ranking_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    target_ = 0;
    chosen_ = true;
    attempts_ = 0;
}

std::optional<SkillIndex> ScoredMethod::step_to_candidate(const Moment& now) {
    const SkillTask& skills = learner_->skills();
    for (; target_ < ranking_.size() && ranking_[target_].score > kNever; ++target_) {
        const SkillIndex target = ranking_[target_].skill;
        attempting_ = skills.applicable(target, now.values);
        if (attempting_) return target;
        const auto condition = skills.precondition(target);
        const std::optional<SkillIndex> step =
            practice_plan_.next(now.values, {condition.begin(), condition.end()});
        if (step) return step;
    }
    return std::nullopt;
}

std::optional<Decision> ScoredMethod::practise(const Moment& now) {
    attempting_ = false;
    if (!chosen_) choose();
    const std::optional<SkillIndex> skill = step_to_candidate(now);
    if (!recorded_) record();
    if (!skill) {
        chosen_ = false;
        return otherwise(now);
    }
    return learner_->decide(*skill, now.state, attempting_ ? Learner::Mode::explore : Learner::Mode::greedy,
                            learner_->random());
}

void ScoredMethod::observe(const Moment& before, const Decision& decision, const Moment& after, bool success,
                           bool test) {
    PlannedMethod::observe(before, decision, after, success, test);
    if (test || !attempting_) return;
    attempting_ = false;
    if (++attempts_ >= learner_->options().score_every) chosen_ = false;
    practice_plan_.forget();
}

void ScoredMethod::record() {
    PracticeChoice choice{cycle_, learner_->transitions(), {}, {}};
    if (target_ < ranking_.size() && ranking_[target_].score > kNever)
        choice.chosen = learner_->skills().name(ranking_[target_].skill);
    for (const Candidate& candidate : ranking_)
        choice.candidates.push_back({learner_->skills().name(candidate.skill), candidate.score,
                                     candidate.competence, candidate.predicted, candidate.cost,
                                     candidate.tries, candidate.successes});
    choices_.push_back(std::move(choice));
    recorded_ = true;
}

void ScoredMethod::end_cycle() {
    ++cycle_;
    chosen_ = false;
    recorded_ = false;
}

std::vector<PracticeChoice> ScoredMethod::take_choices() {
    return std::exchange(choices_, {});
}

}  // namespace praxis::practice
