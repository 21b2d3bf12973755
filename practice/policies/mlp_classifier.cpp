#include "practice/policies/mlp_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "practice/policies/adam.hpp"

namespace praxis::practice {

namespace {

constexpr std::size_t kBatch = 32;
constexpr double kWarmUp = 0.05;  // the part of the steps in which the learning rate rises

float logistic(float x) {
    return 1 / (1 + std::exp(-x));
}

float rate(const ClassifierOptions& options, int step) {
    const double time = (step + 0.5) / options.steps;
    const double factor = std::min(time / kWarmUp, 0.5 * (1 + std::cos(std::numbers::pi * time)));
    return static_cast<float>(options.learning_rate * factor);
}

/// Rows in a random order, again and again in another.
class Shuffled {
  public:
    Shuffled(std::size_t rows, Random& random) : order_(rows), next_(rows), random_(random) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
    }
    std::size_t next() {
        if (next_ == order_.size()) {
            random_.shuffle(order_);
            next_ = 0;
        }
        return order_[next_++];
    }

  private:
    std::vector<std::size_t> order_;
    std::size_t next_;
    Random& random_;
};

}  // namespace

MlpClassifier::MlpClassifier(std::size_t width, const ClassifierOptions& options)
    : width_(width), options_(options), network_(width, options.hidden, 1) {}

void MlpClassifier::fit(const Examples& examples, Random& random) {
    check_examples(examples, width_);
    inputs_ = InputMap(examples, options_.differences);
    const std::size_t size = inputs_.size();
    std::vector<float> inputs(examples.size() * size);
    inputs_.apply(examples.rows, inputs);
    network_ = Mlp(size, options_.hidden, 1);
    network_.initialise(random);

    const std::size_t batch = std::min(kBatch, examples.size());
    Mlp::Workspace workspace(network_, batch);
    Adam adam(network_.weights().size());
    std::vector<float> gradient(network_.weights().size());
    std::vector<float> rows(batch * size);
    std::vector<float> error(batch);
    Shuffled order(examples.size(), random);
    for (int step = 0; step < options_.steps; ++step) {
        for (std::size_t b = 0; b < batch; ++b) {
            const std::size_t row = order.next();
            std::copy_n(inputs.data() + row * size, size, rows.data() + b * size);
            error[b] = examples.success[row] != 0 ? -1.0f : 0.0f;
        }
        const std::span<const float> outputs = network_.forward(rows, workspace);
        for (std::size_t b = 0; b < batch; ++b)
            error[b] = (error[b] + logistic(outputs[b])) / static_cast<float>(batch);
        network_.backward(rows, error, workspace, gradient);
        adam.step(network_.weights(), gradient, rate(options_, step),
                  static_cast<float>(options_.weight_decay));
    }
}

void MlpClassifier::probabilities(std::span<const float> rows, std::span<float> result) const {
    std::vector<float> inputs(rows.size() / width_ * inputs_.size());
    inputs_.apply(rows, inputs);
    network_.evaluate(inputs, result);
    for (float& value : result) value = logistic(value);
}

void MlpClassifier::uncertainties(std::span<const float> rows, std::span<float> result) const {
    probabilities(rows, result);
    for (float& value : result) value = static_cast<float>(entropy(value));
}

}  // namespace praxis::practice
