// A multilayer perceptron: fully connected layers with rectified linear units between them and a linear
// output.
//
// All weights lie in one flat list, so that an optimiser is a loop: layer after layer a matrix (input x unit,
// row after row) and then one bias a unit. Passes take rows in batches and work in a `Workspace` that is
// allocated once, so that training does not allocate. A network is a value; passes do not change it, and
// several threads may use it with workspaces of their own.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis::practice {

class Mlp {
  public:
    /// `hidden` may be empty: a linear model. Throws std::invalid_argument for a layer without units.
    Mlp(std::size_t width, const std::vector<std::size_t>& hidden, std::size_t outputs);

    std::size_t width() const { return sizes_.front(); }
    std::size_t outputs() const { return sizes_.back(); }
    std::span<float> weights() { return weights_; }
    std::span<const float> weights() const { return weights_; }

    /// Random weights, uniform with variance 2 / inputs (He et al., ICCV 2015); biases and the output layer
    /// are zero, so that the untrained network says 0 of everything.
    void initialise(Random& random);

    /// Room for the passes of up to `rows` rows.
    class Workspace {
      public:
        Workspace(const Mlp& network, std::size_t rows);
        std::size_t rows() const { return rows_; }

      private:
        friend class Mlp;
        std::size_t rows_;
        std::vector<std::vector<float>> activations_;  // by layer, without the input: rows * units
        std::vector<float> gradient_, next_gradient_;  // rows * units of the widest layer
        std::vector<float> transposed_;
    };

    /// The outputs of `rows` (a whole number of rows, at most the workspace's), which lie in the workspace.
    std::span<const float> forward(std::span<const float> rows, Workspace& workspace) const;
    /// The outputs of any number of rows.
    void evaluate(std::span<const float> rows, std::span<float> outputs) const;
    /// After `forward` of the same rows: writes the derivative of a loss by each weight, given its derivative
    /// by each output.
    void backward(std::span<const float> rows, std::span<const float> output_gradient, Workspace& workspace,
                  std::span<float> gradient) const;

  private:
    struct Layer {
        std::size_t inputs, units;
        std::size_t matrix, biases;  // where they start among the weights
    };

    std::vector<std::size_t> sizes_;
    std::vector<Layer> layers_;
    std::vector<float> weights_;
};

}  // namespace praxis::practice
