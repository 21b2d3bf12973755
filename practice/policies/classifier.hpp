// Learns from examples how likely a skill succeeds with given parameters.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis::practice {

/// Rows of `width` numbers, each a success or not.
struct Examples {
    std::size_t width = 0;
    std::vector<float> rows;             ///< size() * width, row after row
    std::vector<unsigned char> success;  ///< by row, 0 or 1
    std::size_t size() const { return success.size(); }
};

struct ClassifierOptions {
    std::string kind = "mlp";  ///< mlp, knn or ensemble
    /// mlp, ensemble: units of the hidden layers.
    std::vector<std::size_t> hidden = {32, 32};
    int neighbours = 3;  ///< knn
    int members = 10;    ///< ensemble
};

class Classifier {
  public:
    virtual ~Classifier() = default;
    /// Learns from all examples (those of earlier calls too, again in `examples`; both outcomes occur). The
    /// same examples and seed give the same classifier.
    virtual void fit(const Examples& examples, Random& random) = 0;
    /// The probability of success of each row of `rows`; only after `fit`.
    virtual void probabilities(std::span<const float> rows, std::span<float> result) const = 0;
    /// How unsure the classifier is of each row, in nats of entropy of its probability; an ensemble counts
    /// what its members disagree on.
    virtual void uncertainties(std::span<const float> rows, std::span<float> result) const = 0;
};

/// Throws std::invalid_argument with the kinds there are, or for options out of range.
std::unique_ptr<Classifier> make_classifier(std::size_t width, const ClassifierOptions& options);

}  // namespace praxis::practice
