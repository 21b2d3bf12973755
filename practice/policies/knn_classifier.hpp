// The fraction of successes among the nearest examples, by Euclidean distance of the standardised inputs.
#pragma once

#include "practice/policies/input_map.hpp"

namespace praxis::practice {

class KnnClassifier final : public Classifier {
  public:
    /// Uses the options `differences` and `neighbours` (all examples, where there are fewer), which are in
    /// range.
    KnnClassifier(std::size_t width, const ClassifierOptions& options);
    void fit(const Examples& examples, Random& random) override;
    /// Of examples equally far, the earlier ones count.
    void probabilities(std::span<const float> rows, std::span<float> result) const override;
    void uncertainties(std::span<const float> rows, std::span<float> result) const override;

  private:
    std::size_t width_;
    ClassifierOptions options_;
    InputMap inputs_;
    std::vector<float> columns_;  // input after input, all examples of each
    std::vector<unsigned char> success_;
};

}  // namespace praxis::practice
