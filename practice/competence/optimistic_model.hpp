// Competence by the last cycles alone, and the hope that the largest recent change comes again.
//
// With q_i the share of successes of the i-th last cycle that had outcomes, `predict` is
//
//     competence + cycles (max q - min q)     over the last `recency` of them,
//
// also where the change was a fall; `competence + bonus` while there are fewer than two.
// Source: the released code of Kumar et al., RSS 2024.
#pragma once

#include <vector>

#include "practice/competence/competence_model.hpp"

namespace praxis::practice {

class OptimisticModel : public CompetenceModel {
  public:
    /// `window` and `recency`: at least 1, in cycles that had outcomes.
    OptimisticModel(Beta prior, int window, int recency, double bonus);

    void observe(bool success) override;
    void advance_cycle() override { cycle_open_ = false; }
    void set_prior(Beta prior) override;
    /// Of the window.
    Counts evidence() const override;
    Beta posterior() const override { return prior_.after(evidence()); }
    double predict(int outcomes, int cycles) const override;

  private:
    Beta prior_;
    std::size_t window_, recency_;
    double bonus_;
    bool cycle_open_ = false;     ///< the last of `cycles_` is the present one
    std::vector<Counts> cycles_;  ///< the last ones that had outcomes, as many as are looked at
};

}  // namespace praxis::practice
