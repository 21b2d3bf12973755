// Competence as if the policy never changed: the posterior mean over all outcomes.
#pragma once

#include "practice/competence/competence_model.hpp"

namespace praxis::practice {

/// Predicts that practice adds `bonus`, whatever the outcomes were.
class BetaModel : public CompetenceModel {
  public:
    BetaModel(Beta prior, double bonus) : prior_(prior), bonus_(bonus) {}

    void observe(bool success) override { outcomes_.add(success); }
    void advance_cycle() override {}
    void set_prior(Beta prior) override;
    Counts evidence() const override { return outcomes_; }
    Beta posterior() const override { return prior_.after(outcomes_); }
    double predict(int outcomes, int cycles) const override;

  private:
    Beta prior_;
    double bonus_;
    Counts outcomes_;
};

}  // namespace praxis::practice
