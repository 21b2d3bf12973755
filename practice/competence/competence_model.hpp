// How likely a skill succeeds now, and how likely it would after more practice.
//
// Outcomes come in *cycles*: a cycle ends when the parameter policies have been learned anew
// (`advance_cycle`), so that the outcomes of one cycle are those of one policy. A model answers two
// questions: `competence`, the probability of success under the present policy, and `predict`, what it would
// be after further practice. Models, by name:
//
//   beta         posterior mean over all outcomes; predicts competence + bonus. With the prior Beta(1, 1)
//                this is the thesis's Beta(n+1, m+1).
//   optimistic   posterior mean over the last `window` cycles that had outcomes; extrapolates the largest
//                change of success among the last `recency` of them (Kumar et al., RSS 2024, released code)
//   latent       latent competence that grows by an exponential learning curve of the number of outcomes,
//                fitted by expectation maximisation (the same paper)
//
// A model's state is a function of its options, its prior and the outcomes with their cycles; cycles without
// outcomes change nothing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "practice/competence/beta.hpp"
#include "practice/component.hpp"

namespace praxis::practice {

struct CompetenceOptions {
    std::string model = "latent";
    Beta prior{10, 1};   ///< before any outcome: an optimist's 0.909; the thesis's is {1, 1}
    int window = 5;      ///< optimistic: cycles that the competence now looks at
    int recency = 5;     ///< optimistic: cycles that the extrapolation looks at
    double bonus = 0.5;  ///< beta; optimistic with fewer than two cycles, latent before its first curve
};

class CompetenceModel {
  public:
    virtual ~CompetenceModel() = default;
    virtual void observe(bool success) = 0;
    /// The parameter policies have been learned anew.
    virtual void advance_cycle() = 0;
    /// Another prior, as that of `SharedPrior`; outcomes are kept. Throws std::invalid_argument for one that
    /// is no distribution.
    virtual void set_prior(Beta prior) = 0;
    /// The outcomes that speak of what the prior speaks of, and so of what siblings may expect.
    virtual Counts evidence() const = 0;
    /// The distribution of the probability of success now.
    virtual Beta posterior() const = 0;
    /// Its mean; in [1e-6, 1].
    double competence() const;
    /// What `competence` would be after `outcomes` more outcomes (latent) or as many more cycles as `cycles`
    /// (optimistic), neither negative; in [1e-6, 1].
    virtual double predict(int outcomes, int cycles) const = 0;

  protected:
    /// To [1e-6, 1], where a competence has a finite cost.
    static double clip(double probability);
};

/// All models.
std::vector<Component> competence_models();
/// Throws std::invalid_argument with the names there are, or for options out of range.
std::unique_ptr<CompetenceModel> make_competence_model(const CompetenceOptions& options);

}  // namespace praxis::practice
