#include "practice/policies/classifier.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "practice/policies/ensemble_classifier.hpp"
#include "practice/policies/knn_classifier.hpp"
#include "practice/policies/mlp_classifier.hpp"

namespace praxis::practice {

namespace {

using ClassifierPointer = std::unique_ptr<Classifier>;

struct Entry {
    const char* name;
    const char* description;
    ClassifierPointer (*make)(std::size_t width, const ClassifierOptions& options);
};

template <class Made>
ClassifierPointer make(std::size_t width, const ClassifierOptions& options) {
    return std::make_unique<Made>(width, options);
}

constexpr Entry kEntries[] = {
    {"mlp", "a small neural network", make<MlpClassifier>},
    {"knn", "the outcomes of the nearest examples", make<KnnClassifier>},
    {"ensemble", "several small neural networks that differ in where their training starts", make<EnsembleClassifier>},
};

void check(const ClassifierOptions& options) {
    const auto require = [](bool condition, const char* message) {
        if (!condition) throw std::invalid_argument(message);
    };
    require(options.steps >= 1, "a classifier's steps must be at least 1");
    require(options.learning_rate > 0 && options.learning_rate <= 1,
            "a classifier's learning rate must be positive and at most 1");
    require(options.weight_decay >= 0 && options.weight_decay * options.learning_rate < 1,
            "a classifier's weight decay must not be negative, and below 1 / learning rate");
    require(options.neighbours >= 1, "a classifier's neighbours must be at least 1");
    require(options.members >= 1, "a classifier's members must be at least 1");
}

}  // namespace

void check_examples(const Examples& examples, std::size_t width) {
    if (examples.width != width)
        throw std::invalid_argument("a classifier of rows of " + std::to_string(width) +
                                    " numbers is given examples of " + std::to_string(examples.width));
    const auto successes = std::count_if(examples.success.begin(), examples.success.end(),
                                         [](unsigned char success) { return success != 0; });
    if (successes == 0 || static_cast<std::size_t>(successes) == examples.size())
        throw std::invalid_argument(
            "a classifier learns from successes and failures, not from one of them alone");
}

double entropy(double probability) {
    const auto term = [](double p) { return p > 0 ? -p * std::log(p) : 0.0; };
    return term(probability) + term(1 - probability);
}

std::vector<Component> classifiers() {
    std::vector<Component> result;
    for (const Entry& entry : kEntries) result.push_back({entry.name, entry.description});
    return result;
}

std::unique_ptr<Classifier> make_classifier(std::size_t width, const ClassifierOptions& options) {
    if (width == 0) throw std::invalid_argument("a classifier needs at least one number a row");
    check(options);
    std::string names;
    for (const Entry& entry : kEntries) {
        if (options.kind == entry.name) return entry.make(width, options);
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw std::invalid_argument("no classifier '" + options.kind + "'; there are " + names);
}

}  // namespace praxis::practice
