#include "practice/policies/parameter_policy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "practice/environment.hpp"
#include "practice/policies/feature_selection.hpp"

namespace praxis::practice {

namespace {

/// How much the outcomes must have grown until features are selected anew.
constexpr double kSelectionGrowth = 1.5;

void check(const PolicyOptions& options) {
    if (options.candidates < 1) throw std::invalid_argument("a policy's candidates must be at least 1");
    if (!(options.epsilon >= 0 && options.epsilon <= 1))
        throw std::invalid_argument("a policy's epsilon must be in [0, 1]");
    if (options.exploration != "epsilon-greedy" && options.exploration != "uncertain")
        throw std::invalid_argument("no exploration '" + options.exploration +
                                    "'; there are epsilon-greedy, uncertain");
    if (options.features != "all" && options.features != "relevant" && options.features != "selected")
        throw std::invalid_argument("no choice of features '" + options.features +
                                    "'; there are all, relevant, selected");
}

}  // namespace

struct ParameterPolicy::Implementation {
    std::size_t features, parameters;
    PolicyOptions options;
    std::vector<std::size_t> columns;  // that the classifier sees: of the features, and then the parameters
    Examples outcomes;                 // all features, and then the parameters
    std::size_t successes = 0;
    std::unique_ptr<Classifier> classifier;  // none: not learned yet
    std::size_t learned = 0, selected = 0;   // outcomes at that time

    std::size_t count(std::span<const double> candidates) const {
        if (parameters == 0) return 1;
        if (candidates.empty() || candidates.size() % parameters != 0)
            throw std::invalid_argument("a policy of " + std::to_string(parameters) +
                                        " parameters is given " + std::to_string(candidates.size()) +
                                        " numbers as its candidates");
        return candidates.size() / parameters;
    }

    void check_features(std::span<const double> given) const {
        if (given.size() != features)
            throw std::invalid_argument("a policy of " + std::to_string(features) + " features is given " +
                                        std::to_string(given.size()));
    }

    static float finite(double value) {
        const auto result = static_cast<float>(value);
        if (!std::isfinite(result))
            throw std::invalid_argument(
                "a policy is given a feature or parameter that is not a finite number: " +
                std::to_string(value));
        return result;
    }

    std::vector<float> rows(std::span<const double> state, std::span<const double> candidates) const {
        const std::size_t number = count(candidates);
        std::vector<float> result;
        result.reserve(number * columns.size());
        for (std::size_t c = 0; c < number; ++c)
            for (const std::size_t column : columns)
                result.push_back(finite(column < features ? state[column]
                                                          : candidates[c * parameters + column - features]));
        return result;
    }

    std::vector<float> probabilities(std::span<const double> state,
                                     std::span<const double> candidates) const {
        check_features(state);
        std::vector<float> result(count(candidates));
        classifier->probabilities(rows(state, candidates), result);
        return result;
    }

    std::size_t least_sure(std::span<const double> state, std::span<const double> candidates) const {
        check_features(state);
        std::vector<float> result(count(candidates));
        classifier->uncertainties(rows(state, candidates), result);
        return first_largest(result);
    }

    static std::size_t first_largest(const std::vector<float>& values) {
        return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    }
};

ParameterPolicy::ParameterPolicy(std::size_t features, std::vector<std::size_t> relevant,
                                 std::size_t parameters, const PolicyOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
    check(options);
    for (const std::size_t feature : relevant)
        if (feature >= features)
            throw std::invalid_argument("feature " + std::to_string(feature) +
                                        " is called relevant, but there are " + std::to_string(features));
    Implementation& self = *implementation_;
    self.features = features;
    self.parameters = parameters;
    self.options = options;
    self.columns = std::move(relevant);
    if (options.features != "relevant") {
        self.columns.resize(features);
        std::iota(self.columns.begin(), self.columns.end(), std::size_t{0});
    }
    for (std::size_t p = 0; p < parameters; ++p) self.columns.push_back(features + p);
    self.outcomes.width = features + parameters;
    make_classifier(std::max<std::size_t>(1, self.columns.size()), options.classifier);
}

ParameterPolicy::~ParameterPolicy() = default;
ParameterPolicy::ParameterPolicy(ParameterPolicy&&) noexcept = default;
ParameterPolicy& ParameterPolicy::operator=(ParameterPolicy&&) noexcept = default;

std::size_t ParameterPolicy::best(std::span<const double> features, std::span<const double> candidates,
                                  Random& random) const {
    const Implementation& self = *implementation_;
    if (!self.classifier) return random.below(self.count(candidates));
    return Implementation::first_largest(self.probabilities(features, candidates));
}

ParameterPolicy::Choice ParameterPolicy::explore(std::span<const double> features,
                                                 std::span<const double> candidates, Random& random) const {
    const Implementation& self = *implementation_;
    if (uniform(random) >= self.options.epsilon) return {best(features, candidates, random), true};
    if (self.classifier && self.options.exploration == "uncertain")
        return {self.least_sure(features, candidates), false};
    return {random.below(self.count(candidates)), false};
}

void ParameterPolicy::observe(std::span<const double> features, std::span<const double> parameters,
                              bool success) {
    Implementation& self = *implementation_;
    self.check_features(features);
    if (parameters.size() != self.parameters)
        throw std::invalid_argument("a policy of " + std::to_string(self.parameters) +
                                    " parameters is given " + std::to_string(parameters.size()));
    std::vector<float> row;
    for (const double value : features) row.push_back(Implementation::finite(value));
    for (const double value : parameters) row.push_back(Implementation::finite(value));
    self.outcomes.rows.insert(self.outcomes.rows.end(), row.begin(), row.end());
    self.outcomes.success.push_back(success ? 1 : 0);
    self.successes += success ? 1 : 0;
}

void ParameterPolicy::learn(Random& random) {
    Implementation& self = *implementation_;
    const std::size_t count = self.outcomes.size();
    if (count == self.learned || self.columns.empty() || self.parameters == 0) return;
    if (self.successes == 0 || self.successes == count) return;
    const ClassifierOptions& options = self.options.classifier;
    const bool grown = static_cast<double>(count) >= kSelectionGrowth * static_cast<double>(self.selected);
    if (self.options.features == "selected" && grown) {
        self.columns = select_features(self.outcomes, self.features, options, random);
        self.selected = count;
    }
    self.classifier = make_classifier(self.columns.size(), options);
    self.classifier->fit(with_columns(self.outcomes, self.columns), random);
    self.learned = count;
}

std::size_t ParameterPolicy::outcomes() const {
    return implementation_->outcomes.size();
}

double ParameterPolicy::probability(std::span<const double> features,
                                    std::span<const double> parameters) const {
    const Implementation& self = *implementation_;
    if (!self.classifier) return 0.5;
    if (parameters.size() != self.parameters)
        throw std::invalid_argument("a policy of " + std::to_string(self.parameters) +
                                    " parameters is given " + std::to_string(parameters.size()));
    return self.probabilities(features, parameters).front();
}

}  // namespace praxis::practice
