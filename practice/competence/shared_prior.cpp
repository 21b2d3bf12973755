#include "practice/competence/shared_prior.hpp"

#include <algorithm>
#include <boost/math/special_functions/digamma.hpp>
#include <cmath>
#include <stdexcept>

namespace praxis::practice {
namespace {

/// psi(x + n) - psi(x).
double digamma_rise(double x, std::int64_t n) {
    constexpr std::int64_t kShort = 24;
    if (n > kShort) {
        using Double = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
        return boost::math::digamma(x + static_cast<double>(n), Double()) - boost::math::digamma(x, Double());
    }
    double sum = 0;
    for (std::int64_t j = 0; j < n; ++j) sum += 1 / (x + static_cast<double>(j));
    return sum;
}

}  // namespace

SharedPrior::SharedPrior(std::span<const Counts> siblings, Beta base) : base_(base), prior_(base) {
    check(base);
    for (const Counts& counts : siblings)
        if (counts.successes < 0 || counts.failures < 0)
            throw std::invalid_argument("counts of outcomes must not be negative");
    constexpr int kSteps = 200;
    constexpr double kEnough = 1e-6;
    for (int i = 0; i < kSteps; ++i) {
        terms_ = terms(siblings);
        const Beta next = step(terms_);
        const double change = std::max(std::abs(next.successes - prior_.successes) / prior_.successes,
                                       std::abs(next.failures - prior_.failures) / prior_.failures);
        if (change < kEnough) return;
        prior_ = next;
    }
    terms_ = terms(siblings);
}

SharedPrior::Terms SharedPrior::terms(const Counts& counts) const {
    return {prior_.successes * digamma_rise(prior_.successes, counts.successes),
            prior_.failures * digamma_rise(prior_.failures, counts.failures),
            digamma_rise(prior_.strength(), counts.total())};
}

SharedPrior::Terms SharedPrior::terms(std::span<const Counts> siblings) const {
    Terms sum;
    for (const Counts& counts : siblings) {
        const Terms one = terms(counts);
        sum.successes += one.successes;
        sum.failures += one.failures;
        sum.all += one.all;
    }
    return sum;
}

Beta SharedPrior::step(const Terms& terms) const {
    return {(base_.successes + terms.successes) / (1 + terms.all),
            (base_.failures + terms.failures) / (1 + terms.all)};
}

Beta SharedPrior::without(const Counts& sibling) const {
    const Terms own = terms(sibling);
    return step({std::max(0.0, terms_.successes - own.successes),
                 std::max(0.0, terms_.failures - own.failures), std::max(0.0, terms_.all - own.all)});
}

Beta shared_prior(std::span<const Counts> siblings, Beta base) {
    return SharedPrior(siblings, base).prior();
}

}  // namespace praxis::practice
