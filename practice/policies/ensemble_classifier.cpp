#include "practice/policies/ensemble_classifier.hpp"

#include <algorithm>

namespace praxis::practice {

EnsembleClassifier::EnsembleClassifier(std::size_t width, const ClassifierOptions& options)
    : members_(static_cast<std::size_t>(options.members), MlpClassifier(width, options)) {}

void EnsembleClassifier::fit(const Examples& examples, Random& random) {
    for (MlpClassifier& member : members_) member.fit(examples, random);
}

void EnsembleClassifier::probabilities(std::span<const float> rows, std::span<float> result) const {
    std::vector<float> one(result.size());
    std::fill(result.begin(), result.end(), 0.0f);
    for (const MlpClassifier& member : members_) {
        member.probabilities(rows, one);
        for (std::size_t i = 0; i < one.size(); ++i)
            result[i] += one[i] / static_cast<float>(members_.size());
    }
}

void EnsembleClassifier::uncertainties(std::span<const float> rows, std::span<float> result) const {
    std::vector<float> one(result.size());
    std::vector<double> own(result.size());
    std::fill(result.begin(), result.end(), 0.0f);
    for (const MlpClassifier& member : members_) {
        member.probabilities(rows, one);
        for (std::size_t i = 0; i < one.size(); ++i) {
            result[i] += one[i] / static_cast<float>(members_.size());
            own[i] += entropy(one[i]) / static_cast<double>(members_.size());
        }
    }
    for (std::size_t i = 0; i < one.size(); ++i)
        result[i] = static_cast<float>(std::max(0.0, entropy(std::min(1.0f, result[i])) - own[i]));
}

}  // namespace praxis::practice
