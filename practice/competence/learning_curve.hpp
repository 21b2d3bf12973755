// The exponential learning curve: how competence grows with the number of outcomes learned from.
//
//     mean(x) = t0 + (t1 - t0)(1 - exp(-t2 x)),    t0 = sigmoid(start), t1 = sigmoid(start +
//     positive(growth)),
//                                                  t2 = positive(rate),  positive(z) = elu(z) + 1
//
// so that every triple of numbers is a curve that rises from t0 in (0, 1) towards t1 in (t0, 1).
// Source: Kumar et al., RSS 2024.
#pragma once

#include <array>

namespace praxis::practice {

using CurveParameters = std::array<double, 3>;  ///< start, growth, rate

/// A curve at hand, ready to be asked at many places.
class LearningCurve {
  public:
    explicit LearningCurve(const CurveParameters& parameters);

    /// The competence after learning from x >= 0 outcomes.
    double mean(double x) const;
    /// The same; writes its derivatives by the parameters.
    double mean(double x, CurveParameters& gradient) const;

  private:
    double first_, last_, rate_;  ///< t0, t1, t2
    double first_by_start_, last_by_start_, last_by_growth_, rate_by_rate_;
};

}  // namespace praxis::practice
