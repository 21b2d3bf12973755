#include "search/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace praxis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void require_confidence(double confidence) {
    if (!(confidence > 0 && confidence < 1))
        throw std::invalid_argument("a confidence is between 0 and 1, such as 0.95");
}

struct Moments {
    double mean = 0;
    double standard_error = 0;  ///< of the mean; infinite for one value
};

/// Two passes: exact for equal values.
Moments moments(std::span<const double> values) {
    if (values.empty()) throw std::invalid_argument("no values to estimate from");
    const double count = static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values) {
        if (!std::isfinite(value)) throw std::invalid_argument("a value to estimate from is not finite");
        sum += value - values.front();
    }
    const double mean = values.front() + sum / count;
    if (values.size() == 1) return {mean, kInfinity};
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count - 1) / count)};
}

}  // namespace

double student_quantile(double probability, double degrees) {
    if (!(probability > 0 && probability < 1) || !(degrees > 0))
        throw std::invalid_argument("Student's quantile needs a probability in (0, 1) and degrees above 0");
    return boost::math::quantile(boost::math::students_t(degrees), probability);
}

IntervalEstimate mean_estimate(std::span<const double> values, double confidence) {
    require_confidence(confidence);
    const auto [mean, standard_error] = moments(values);
    if (values.size() == 1) return {mean, -kInfinity, kInfinity, 1};
    const double reach =
        standard_error * student_quantile((1 + confidence) / 2, static_cast<double>(values.size() - 1));
    return {mean, mean - reach, mean + reach, values.size()};
}

IntervalEstimate fraction_estimate(std::span<const double> fractions, double confidence) {
    IntervalEstimate result = mean_estimate(fractions, confidence);
    result.low = std::max(0.0, result.low);
    result.high = std::min(1.0, result.high);
    return result;
}

IntervalEstimate proportion_estimate(std::int64_t successes, std::int64_t trials, double confidence) {
    require_confidence(confidence);
    if (trials <= 0 || successes < 0 || successes > trials)
        throw std::invalid_argument("a proportion needs trials, and no more successes than trials");
    const double n = static_cast<double>(trials);
    const double share = static_cast<double>(successes) / n;
    const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
    const double weight = 1 + z * z / n;
    const double middle = (share + z * z / (2 * n)) / weight;
    const double reach = z / weight * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    return {share, successes == 0 ? 0.0 : std::max(0.0, middle - reach),
            successes == trials ? 1.0 : std::min(1.0, middle + reach), static_cast<std::size_t>(trials)};
}

PairedComparison compare_paired(std::span<const double> a, std::span<const double> b, double confidence) {
    if (a.size() != b.size()) throw std::invalid_argument("pairs need two lists of one length");
    std::vector<double> differences(a.size());
    PairedComparison result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        differences[i] = a[i] - b[i];
        ++(a[i] > b[i] ? result.wins : a[i] < b[i] ? result.losses : result.ties);
    }
    result.difference = mean_estimate(differences, confidence);
    if (differences.size() == 1) return result;
    const auto [mean, standard_error] = moments(differences);
    if (standard_error == 0) {
        result.probability = mean == 0 ? 1 : 0;
        return result;
    }
    const boost::math::students_t distribution(static_cast<double>(differences.size() - 1));
    result.probability = 2 * boost::math::cdf(distribution, -std::abs(mean / standard_error));
    return result;
}

}  // namespace praxis
