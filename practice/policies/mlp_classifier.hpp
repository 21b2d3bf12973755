// Logistic regression by a multilayer perceptron, trained anew in milliseconds.
//
// The published one (Kumar et al., RSS 2024) makes up to 100,000 steps on all examples with a small learning
// rate. This one makes some hundred steps on 32 rows each, with a large rate that rises shortly and then
// falls with the cosine, and with weight decay; bench/policy_bench.cpp compares what is chosen by it.
#pragma once

#include "practice/policies/input_map.hpp"
#include "practice/policies/mlp.hpp"

namespace praxis::practice {

class MlpClassifier final : public Classifier {
  public:
    /// Uses the options `differences`, `hidden`, `steps`, `learning_rate` and `weight_decay`, which are in
    /// range.
    MlpClassifier(std::size_t width, const ClassifierOptions& options);
    void fit(const Examples& examples, Random& random) override;
    void probabilities(std::span<const float> rows, std::span<float> result) const override;
    void uncertainties(std::span<const float> rows, std::span<float> result) const override;

  private:
    std::size_t width_;
    ClassifierOptions options_;
    InputMap inputs_;
    Mlp network_;
};

}  // namespace praxis::practice
