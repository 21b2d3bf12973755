#include "practice/policies/knn_classifier.hpp"

#include <algorithm>
#include <numeric>

namespace praxis::practice {

KnnClassifier::KnnClassifier(std::size_t width, const ClassifierOptions& options)
    : width_(width), options_(options) {}

void KnnClassifier::fit(const Examples& examples, Random&) {
    check_examples(examples, width_);
    inputs_ = InputMap(examples, options_.differences);
    const std::size_t size = inputs_.size();
    const std::size_t count = examples.size();
    std::vector<float> inputs(count * size);
    inputs_.apply(examples.rows, inputs);
    columns_.resize(inputs.size());
    for (std::size_t r = 0; r < count; ++r)
        for (std::size_t i = 0; i < size; ++i) columns_[i * count + r] = inputs[r * size + i];
    success_ = examples.success;
}

void KnnClassifier::probabilities(std::span<const float> rows, std::span<float> result) const {
    const std::size_t count = success_.size();
    const std::size_t size = inputs_.size();
    const std::size_t nearest = std::min(count, static_cast<std::size_t>(options_.neighbours));
    std::vector<float> inputs(size);
    std::vector<float> distance(count);
    std::vector<std::size_t> order(count);
    for (std::size_t q = 0; q < result.size(); ++q) {
        inputs_.apply(rows.subspan(q * width_, width_), inputs);
        std::fill(distance.begin(), distance.end(), 0.0f);
        for (std::size_t i = 0; i < size; ++i) {
            const float* const column = columns_.data() + i * count;
            for (std::size_t r = 0; r < count; ++r)
                distance[r] += (column[r] - inputs[i]) * (column[r] - inputs[i]);
        }
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto middle = order.begin() + static_cast<std::ptrdiff_t>(nearest - 1);
        std::nth_element(order.begin(), middle, order.end(), [&](std::size_t a, std::size_t b) {
            return distance[a] != distance[b] ? distance[a] < distance[b] : a < b;
        });
        const auto successes =
            std::count_if(order.begin(), middle + 1, [&](std::size_t r) { return success_[r] != 0; });
        result[q] = static_cast<float>(successes) / static_cast<float>(nearest);
    }
}

void KnnClassifier::uncertainties(std::span<const float> rows, std::span<float> result) const {
    probabilities(rows, result);
    for (float& value : result) value = static_cast<float>(entropy(value));
}

}  // namespace praxis::practice
