// The mean of perceptrons that start from different weights and see the examples in different orders.
//
// Few successes are too precious to leave some of them out of a member's sample, so there is no bootstrap
// (Lakshminarayanan et al., NeurIPS 2017, find the same).
#pragma once

#include "practice/policies/mlp_classifier.hpp"

namespace praxis::practice {

class EnsembleClassifier final : public Classifier {
  public:
    /// Uses the option `members` and those of MlpClassifier, which are in range.
    EnsembleClassifier(std::size_t width, const ClassifierOptions& options);
    void fit(const Examples& examples, Random& random) override;
    void probabilities(std::span<const float> rows, std::span<float> result) const override;
    void uncertainties(std::span<const float> rows, std::span<float> result) const override;

  private:
    std::vector<MlpClassifier> members_;
};

}  // namespace praxis::practice
