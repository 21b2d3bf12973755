#include "practice/competence/latent_model.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::practice {
namespace {

CurvePrior curve_prior(const Beta& prior) {
    CurvePrior result;
    result.mean[0] = std::log(prior.successes) - std::log(prior.failures);
    result.deviation[0] = std::sqrt(1 / prior.successes + 1 / prior.failures);
    return result;
}

}  // namespace

LatentModel::LatentModel(Beta prior, double bonus) : prior_(prior), bonus_(bonus) {
    fit_.parameters = curve_prior(prior).mean;
}

void LatentModel::advance_cycle() {
    if (present_.outcomes.total() == 0) return;
    past_.push_back(present_);
    present_ = {present_.before + static_cast<double>(present_.outcomes.total()), {}};
    fit();
}

void LatentModel::set_prior(Beta prior) {
    check(prior);
    if (prior == prior_) return;
    prior_ = prior;
    fit();
}

void LatentModel::fit() {
    const CurvePrior prior = curve_prior(prior_);
    if (fitted())
        fit_ = fit_curve(past_, prior, fit_.parameters);
    else
        fit_.parameters = prior.mean;
}

Counts LatentModel::evidence() const {
    return fitted() ? past_.front().outcomes : present_.outcomes;
}

double LatentModel::curve(double x) const {
    return std::clamp(LearningCurve(fit_.parameters).mean(x), 1e-3, 1 - 1e-3);
}

Beta LatentModel::posterior() const {
    if (!fitted()) return prior_.after(present_.outcomes);
    const auto successes = static_cast<double>(present_.outcomes.successes);
    const auto failures = static_cast<double>(present_.outcomes.failures);
    const double c = most_probable_competence(curve(present_.before), present_.outcomes);
    const double precision = successes / (c * c) + failures / ((1 - c) * (1 - c)) + 1 / kCompetenceVariance;
    const double strength = std::max(1.0, c * (1 - c) * precision - 1);
    return {strength * c, strength * (1 - c)};
}

double LatentModel::predict(int outcomes, int /*cycles*/) const {
    if (!fitted()) return clip(competence() + bonus_);
    const double learned_from = present_.before + static_cast<double>(present_.outcomes.total()) + outcomes;
    return clip(competence() + curve(learned_from) - curve(present_.before));
}

}  // namespace praxis::practice
