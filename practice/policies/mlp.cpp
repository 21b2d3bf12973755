#include "practice/policies/mlp.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "practice/environment.hpp"
#include "practice/policies/matrix_product.hpp"

namespace praxis::practice {

namespace {

constexpr std::size_t kEvaluatedRows = 64;

void rectify(std::span<float> values) {
    for (float& value : values) value = value > 0 ? value : 0.0f;
}

/// A rectified unit passes a gradient on where it is active.
void mask(std::span<float> gradient, const float* activations) {
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] = activations[i] > 0 ? gradient[i] : 0.0f;
}

void transpose(const float* matrix, std::size_t rows, std::size_t columns, float* result) {
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) result[j * rows + i] = matrix[i * columns + j];
}

}  // namespace

Mlp::Mlp(std::size_t width, const std::vector<std::size_t>& hidden, std::size_t outputs) {
    sizes_.push_back(width);
    sizes_.insert(sizes_.end(), hidden.begin(), hidden.end());
    sizes_.push_back(outputs);
    if (std::find(sizes_.begin() + 1, sizes_.end(), 0u) != sizes_.end())
        throw std::invalid_argument("a layer of a perceptron needs at least one unit");
    std::size_t next = 0;
    for (std::size_t l = 0; l + 1 < sizes_.size(); ++l) {
        const std::size_t entries = sizes_[l] * sizes_[l + 1];
        layers_.push_back({sizes_[l], sizes_[l + 1], next, next + entries});
        next += entries + sizes_[l + 1];
    }
    weights_.assign(next, 0.0f);
}

void Mlp::initialise(Random& random) {
    std::fill(weights_.begin(), weights_.end(), 0.0f);
    for (std::size_t l = 0; l + 1 < layers_.size(); ++l) {
        const double bound = std::sqrt(6.0 / static_cast<double>(layers_[l].inputs));
        for (std::size_t w = layers_[l].matrix; w < layers_[l].biases; ++w)
            weights_[w] = static_cast<float>(uniform(random, -bound, bound));
    }
}

Mlp::Workspace::Workspace(const Mlp& network, std::size_t rows) : rows_(rows) {
    std::size_t widest = 0;
    std::size_t largest = 0;
    for (const Layer& layer : network.layers_) {
        activations_.emplace_back(rows * layer.units);
        widest = std::max(widest, layer.units);
        largest = std::max(largest, layer.inputs * layer.units);
    }
    gradient_.resize(rows * widest);
    next_gradient_.resize(rows * widest);
    transposed_.resize(largest);
}

std::span<const float> Mlp::forward(std::span<const float> rows, Workspace& workspace) const {
    const std::size_t count = rows.size() / width();
    const float* inputs = rows.data();
    for (std::size_t l = 0; l < layers_.size(); ++l) {
        const Layer& layer = layers_[l];
        float* units = workspace.activations_[l].data();
        const float* biases = weights_.data() + layer.biases;
        for (std::size_t r = 0; r < count; ++r) std::copy_n(biases, layer.units, units + r * layer.units);
        add_product({inputs, layer.inputs, 1}, weights_.data() + layer.matrix, units, count, layer.inputs,
                    layer.units);
        if (l + 1 < layers_.size()) rectify({units, count * layer.units});
        inputs = units;
    }
    return {inputs, count * outputs()};
}

void Mlp::evaluate(std::span<const float> rows, std::span<float> outputs) const {
    const std::size_t count = rows.size() / width();
    Workspace workspace(*this, std::min(count, kEvaluatedRows));
    for (std::size_t first = 0; first < count; first += kEvaluatedRows) {
        const std::size_t size = std::min(kEvaluatedRows, count - first);
        const auto result = forward(rows.subspan(first * width(), size * width()), workspace);
        std::copy(result.begin(), result.end(),
                  outputs.begin() + static_cast<std::ptrdiff_t>(first * this->outputs()));
    }
}

void Mlp::backward(std::span<const float> rows, std::span<const float> output_gradient, Workspace& workspace,
                   std::span<float> gradient) const {
    const std::size_t count = output_gradient.size() / outputs();
    std::fill(gradient.begin(), gradient.end(), 0.0f);
    const float* units_gradient = output_gradient.data();
    for (std::size_t l = layers_.size(); l-- > 0;) {
        const Layer& layer = layers_[l];
        const float* inputs = l == 0 ? rows.data() : workspace.activations_[l - 1].data();
        add_product({inputs, 1, layer.inputs}, units_gradient, gradient.data() + layer.matrix, layer.inputs,
                    count, layer.units);
        float* biases = gradient.data() + layer.biases;
        for (std::size_t r = 0; r < count; ++r)
            for (std::size_t u = 0; u < layer.units; ++u) biases[u] += units_gradient[r * layer.units + u];
        if (l == 0) break;
        transpose(weights_.data() + layer.matrix, layer.inputs, layer.units, workspace.transposed_.data());
        const std::span<float> inputs_gradient(workspace.next_gradient_.data(), count * layer.inputs);
        std::fill(inputs_gradient.begin(), inputs_gradient.end(), 0.0f);
        add_product({units_gradient, layer.units, 1}, workspace.transposed_.data(), inputs_gradient.data(),
                    count, layer.units, layer.inputs);
        mask(inputs_gradient, inputs);
        std::swap(workspace.gradient_, workspace.next_gradient_);
        units_gradient = workspace.gradient_.data();
    }
}

}  // namespace praxis::practice
