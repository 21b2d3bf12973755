// Competence as a latent quantity that follows a learning curve.
//
// Before the first cycle with outcomes has ended, competence is what the prior and the outcomes say, and
// `predict` adds the bonus. From then on, with x outcomes before the present cycle and n in it,
//
//     competence          = most probable competence near the curve's mean(x), given the cycle's n outcomes
//     predict(outcomes)   = competence + mean(x + n + outcomes) - mean(x)
//
// since the next policy is learned from the present cycle's outcomes too. The curve is fitted at the end of
// each cycle (`fit_curve`); the prior of the competence is, in log-odds and to first order, that of its
// start. Source: Kumar et al., RSS 2024.
#pragma once

#include <span>
#include <vector>

#include "practice/competence/competence_model.hpp"
#include "practice/competence/fit_curve.hpp"

namespace praxis::practice {

class LatentModel : public CompetenceModel {
  public:
    LatentModel(Beta prior, double bonus);

    void observe(bool success) override { present_.outcomes.add(success); }
    void advance_cycle() override;
    void set_prior(Beta prior) override;
    /// Of the first cycle that had any: the prior speaks of the curve's start.
    Counts evidence() const override;
    Beta posterior() const override;
    double predict(int outcomes, int cycles) const override;

    /// The objective of the last fit after each of its rounds; empty before the first.
    std::span<const double> objective() const { return fit_.objective; }
    /// What the curve says of the competence after x outcomes; in [0.001, 0.999].
    double curve(double x) const;

  private:
    bool fitted() const { return !past_.empty(); }
    void fit();

    Beta prior_;
    double bonus_;
    Cycle present_;
    std::vector<Cycle> past_;  ///< those that had outcomes
    CurveFit fit_;
};

}  // namespace praxis::practice
