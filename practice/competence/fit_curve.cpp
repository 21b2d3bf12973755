#include "practice/competence/fit_curve.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::practice {
namespace {

constexpr double kLowest = 1e-3, kHighest = 1 - kLowest;
constexpr double kPrecision = 1 / kCompetenceVariance;
constexpr int kRounds = 30;
constexpr double kEnoughGain = 1e-2;  ///< of J, in nats a round

double square(double x) {
    return x * x;
}

/// Solves (A + damping diag(A)) x = b for a positive definite A, of which the lower triangle is given.
CurveParameters solve(const std::array<CurveParameters, 3>& a, const CurveParameters& b, double damping) {
    std::array<CurveParameters, 3> lower{};
    CurveParameters x = b;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column <= row; ++column) {
            double value = row == column ? a[row][row] * (1 + damping) : a[row][column];
            for (std::size_t k = 0; k < column; ++k) value -= lower[row][k] * lower[column][k];
            lower[row][column] = row == column ? std::sqrt(value) : value / lower[column][column];
        }
        for (std::size_t k = 0; k < row; ++k) x[row] -= lower[row][k] * x[k];
        x[row] /= lower[row][row];
    }
    for (std::size_t row = 3; row-- > 0;) {
        for (std::size_t k = row + 1; k < 3; ++k) x[row] -= lower[k][row] * x[k];
        x[row] /= lower[row][row];
    }
    return x;
}

/// The state of one ascent.
class Ascent {
  public:
    Ascent(std::span<const Cycle> cycles, const CurvePrior& prior, const CurveParameters& start)
        : cycles_(cycles), prior_(prior), competences_(cycles.size()) {
        fit_.parameters = start;
    }

    CurveFit run() {
        for (int round = 0; round < kRounds; ++round) {
            const double likelihood = infer_competences();
            fit_.objective.push_back(likelihood - learn_curve());
            if (round > 0 && fit_.objective.back() - fit_.objective.end()[-2] < kEnoughGain) break;
        }
        return std::move(fit_);
    }

  private:
    /// The E-step. Returns the log-likelihood of the outcomes.
    double infer_competences() {
        const LearningCurve curve(fit_.parameters);
        double likelihood = 0;
        for (std::size_t i = 0; i < cycles_.size(); ++i) {
            const Cycle& cycle = cycles_[i];
            const double c = competences_[i] =
                most_probable_competence(curve.mean(cycle.before), cycle.outcomes);
            likelihood += static_cast<double>(cycle.outcomes.successes) * std::log(c) +
                          static_cast<double>(cycle.outcomes.failures) * std::log1p(-c);
        }
        return likelihood;
    }

    /// What the M-step lowers, half the weighted squares, and Gauss-Newton's normal equations, at one curve.
    struct Squares {
        double value = 0;
        std::array<CurveParameters, 3> normal{};
        CurveParameters descent{};
    };
    Squares squares(const CurveParameters& parameters) const {
        Squares result;
        const LearningCurve curve(parameters);
        CurveParameters gradient;
        for (std::size_t i = 0; i < cycles_.size(); ++i) {
            const double residual = competences_[i] - curve.mean(cycles_[i].before, gradient);
            result.value += kPrecision / 2 * square(residual);
            for (std::size_t row = 0; row < 3; ++row) {
                result.descent[row] += kPrecision * residual * gradient[row];
                for (std::size_t column = 0; column <= row; ++column)
                    result.normal[row][column] += kPrecision * gradient[row] * gradient[column];
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const double precision = 1 / square(prior_.deviation[k]);
            const double residual = prior_.mean[k] - parameters[k];
            result.value += precision / 2 * square(residual);
            result.descent[k] += precision * residual;
            result.normal[k][k] += precision;
        }
        return result;
    }

    /// The M-step, until a step gains little beside what a round must. Returns the squares that are left.
    double learn_curve() {
        constexpr int kSteps = 20;
        Squares present = squares(fit_.parameters);
        double damping = 1e-3;
        for (int step = 0; step < kSteps; ++step) {
            const CurveParameters change = solve(present.normal, present.descent, damping);
            CurveParameters next = fit_.parameters;
            for (std::size_t k = 0; k < 3; ++k) next[k] += change[k];
            const Squares reached = squares(next);
            const double gain = present.value - reached.value;
            if (!(gain > 0)) {
                damping *= 10;
                continue;
            }
            fit_.parameters = next;
            present = reached;
            damping /= 10;
            if (gain < kEnoughGain) break;
        }
        return present.value;
    }

    std::span<const Cycle> cycles_;
    const CurvePrior& prior_;
    std::vector<double> competences_;
    CurveFit fit_;
};

}  // namespace

double most_probable_competence(double mean, const Counts& outcomes) {
    const auto successes = static_cast<double>(outcomes.successes);
    const auto failures = static_cast<double>(outcomes.failures);
    const auto slope = [&](double c) { return successes / c - failures / (1 - c) - kPrecision * (c - mean); };
    double low = kLowest, high = kHighest;
    if (slope(low) <= 0) return low;
    if (slope(high) >= 0) return high;
    const double weight = std::max(1.0, kPrecision * mean * (1 - mean) - 1);
    double c = (weight * mean + successes) / (weight + successes + failures);
    for (int step = 0; step < 100; ++step) {
        if (!(c > low && c < high)) c = (low + high) / 2;
        const double value = slope(c);
        (value > 0 ? low : high) = c;
        const double change = value / (successes / square(c) + failures / square(1 - c) + kPrecision);
        c += change;
        if (std::abs(change) < 1e-8) break;
    }
    return std::clamp(c, low, high);
}

CurveFit fit_curve(std::span<const Cycle> cycles, const CurvePrior& prior, const CurveParameters& guess) {
    CurveFit best = Ascent(cycles, prior, prior.mean).run();
    if (guess == prior.mean) return best;
    CurveFit other = Ascent(cycles, prior, guess).run();
    return other.objective.back() > best.objective.back() ? other : best;
}

}  // namespace praxis::practice
