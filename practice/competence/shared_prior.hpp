// What the ground skills of one schema tell each other: a prior fitted to all of them.
//
// Ground skill i of a schema has competence c_i ~ Beta(A, B) and s_i successes, f_i failures of n_i. A and B
// are those that maximise the beta-binomial likelihood of all outcomes times a hyperprior that keeps them
// near the base prior Beta(A0, B0):
//
//     sum_i log BetaBinomial(s_i | n_i, A, B)  +  A0 log A - A  +  B0 log B - B
//
// by Minka's fixed point, each step of which maximises a lower bound that touches at the present A and B, so
// that no step lowers the sum (psi is the digamma function):
//
//     A <- (A0 + A sum_i [psi(A + s_i) - psi(A)]) / (1 + sum_i [psi(A + B + n_i) - psi(A + B)]),
//     B likewise with B0 and f_i
//
// Without outcomes the base comes back exactly; with one outcome the mean is the usual (A0 + s) / (A0 + B0 +
// 1), the strength unchanged; many siblings that agree make it strong, siblings that differ make it weak.
//
// The prior of a skill that was tried itself is `without` it (its outcomes come in anyway): one more step of
// the fixed point without its terms, which for an only child is the base. Source: T. Minka, "Estimating a
// Dirichlet distribution", 2000 (the hyperprior is ours).
#pragma once

#include <span>

#include "practice/competence/beta.hpp"

namespace praxis::practice {

class SharedPrior {
  public:
    /// Throws std::invalid_argument for a base that is no distribution, or negative counts.
    SharedPrior(std::span<const Counts> siblings, Beta base);

    /// For a skill that has not been tried.
    const Beta& prior() const { return prior_; }
    /// For one of the siblings, by the others.
    Beta without(const Counts& sibling) const;

  private:
    /// Of the fixed point: what outcomes add above and below the fraction.
    struct Terms {
        double successes = 0, failures = 0, all = 0;
    };
    Terms terms(const Counts& counts) const;
    Terms terms(std::span<const Counts> siblings) const;
    Beta step(const Terms& terms) const;

    Beta base_, prior_;
    Terms terms_;  ///< of all siblings, at `prior_`
};

/// The prior for a skill that has not been tried.
Beta shared_prior(std::span<const Counts> siblings, Beta base);

}  // namespace praxis::practice
