// Fits a learning curve to outcomes, by expectation maximisation with MAP competences.
//
// Cycle i, whose policy was learned from x_i outcomes, has a latent competence c_i near the curve's
// mean(x_i), and s_i successes and f_i failures. The objective, over curve and competences, is the joint
// log-posterior (up to a constant)
//
//     J(curve, c) = sum_i  s_i log c_i + f_i log(1 - c_i) - (c_i - mean(x_i))^2 / 2v
//                 - sum_k  (parameter_k - prior_k)^2 / 2 deviation_k^2,                  c_i in [0.001,
//                 0.999]
//
// with v the variance of competences about the curve. A round is coordinate ascent on J, so J cannot fall:
//
//   E   c_i <- argmax of J, one strictly concave problem a cycle: where n c(1-c) is not tiny this is the
//       posterior mean under the Beta with mean(x_i) and v, which the source takes instead
//   M   curve <- regularised least squares on the c_i, by Levenberg-Marquardt from the present curve; a step
//       is taken only if it lowers the squares
//
// The prior of the curve is what makes three parameters meaningful after one or two cycles.
// Source: Kumar et al., RSS 2024 (there without a prior, and by gradient descent).
#pragma once

#include <span>
#include <vector>

#include "practice/competence/counts.hpp"
#include "practice/competence/learning_curve.hpp"

namespace praxis::practice {

/// Independent normal distributions of a curve's parameters.
struct CurvePrior {
    /// A growth by 1 in log-odds, half of it within about 23 outcomes.
    CurveParameters mean{0, 0, -3.5}, deviation{1, 2, 1};
};

/// The outcomes of one policy.
struct Cycle {
    double before = 0;  ///< outcomes that the policy was learned from
    Counts outcomes;
};

struct CurveFit {
    CurveParameters parameters{};
    std::vector<double> objective;  ///< J after each round; never falls
};

inline constexpr double kCompetenceVariance = 0.01;  ///< v

/// The E-step of one cycle: its most probable competence, where the curve says `mean`; in [0.001, 0.999].
double most_probable_competence(double mean, const Counts& outcomes);

/// The better by J of two ascents, one from `guess` and one from the prior's mean.
CurveFit fit_curve(std::span<const Cycle> cycles, const CurvePrior& prior, const CurveParameters& guess);

}  // namespace praxis::practice
