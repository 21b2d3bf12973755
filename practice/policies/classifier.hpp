// Learns from examples how likely a skill succeeds with given parameters.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "practice/component.hpp"
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
    /// Whether pairwise differences of a row's numbers are inputs too (see InputMap).
    bool differences = true;
    /// mlp, ensemble: units of the hidden layers.
    std::vector<std::size_t> hidden = {32, 32};
    int steps = 300;              ///< mlp, ensemble: of training, each on 32 rows
    double learning_rate = 0.03;  ///< mlp, ensemble: of the first steps; falls to 0
    double weight_decay = 0.5;    ///< mlp, ensemble: a weight loses learning rate * decay of itself a step
    int neighbours = 3;           ///< knn
    int members = 5;              ///< ensemble
};

class Classifier {
  public:
    virtual ~Classifier() = default;
    /// Learns from all examples (those of earlier calls too, again in `examples`). The same examples and seed
    /// give the same classifier, whatever it was before. Throws std::invalid_argument if not both outcomes
    /// occur, for a wrong width, or for numbers that are not finite.
    virtual void fit(const Examples& examples, Random& random) = 0;
    /// The probability of success of each row of `rows`; only after `fit`.
    virtual void probabilities(std::span<const float> rows, std::span<float> result) const = 0;
    /// How unsure the classifier is of each row, in nats: the entropy of its probability; of an ensemble only
    /// what its members disagree on (the information a trial would give about which of them is right; Houlsby
    /// et al., 2011).
    virtual void uncertainties(std::span<const float> rows, std::span<float> result) const = 0;
};

/// Throws std::invalid_argument unless the examples are of this width and both outcomes occur.
void check_examples(const Examples& examples, std::size_t width);

/// Of an event, in nats.
double entropy(double probability);

/// All kinds.
std::vector<Component> classifiers();
/// Throws std::invalid_argument with the kinds there are, or for options out of range.
std::unique_ptr<Classifier> make_classifier(std::size_t width, const ClassifierOptions& options);

}  // namespace praxis::practice
