#include "practice/competence/learning_curve.hpp"

#include <cmath>

namespace praxis::practice {
namespace {

double sigmoid(double z) {
    return 1 / (1 + std::exp(-z));
}
double positive(double z) {
    return z > 0 ? z + 1 : std::exp(z);
}
double positive_slope(double z) {
    return z > 0 ? 1 : std::exp(z);
}

}  // namespace

LearningCurve::LearningCurve(const CurveParameters& parameters) {
    const auto [start, growth, rate] = parameters;
    first_ = sigmoid(start);
    last_ = sigmoid(start + positive(growth));
    rate_ = positive(rate);
    first_by_start_ = first_ * (1 - first_);
    last_by_start_ = last_ * (1 - last_);
    last_by_growth_ = last_by_start_ * positive_slope(growth);
    rate_by_rate_ = positive_slope(rate);
}

double LearningCurve::mean(double x) const {
    const double left = std::exp(-rate_ * x);
    return last_ - left * (last_ - first_);
}

double LearningCurve::mean(double x, CurveParameters& gradient) const {
    const double left = std::exp(-rate_ * x);
    gradient[0] = left * first_by_start_ + (1 - left) * last_by_start_;
    gradient[1] = (1 - left) * last_by_growth_;
    gradient[2] = (last_ - first_) * left * x * rate_by_rate_;
    return last_ - left * (last_ - first_);
}

}  // namespace praxis::practice
