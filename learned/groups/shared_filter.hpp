// Filters whose weights are shared so that convolution commutes with a group.
//
// A filter w[input k][tap t][output l] between fields maps turned fields to the turned result if and only if
// w[g k][g t][g l] = w[k][t][l] for all elements g. So there is one free weight for each orbit of the group
// on the triples (k, t, l): 9 a pair of fields for lifting a scalar to a regular field of D4 with 3x3 taps,
// 72 between two regular fields (Cohen and Welling, Group equivariant convolutional networks, ICML 2016), 4
// between a regular field and the four moves. The whole space of equivariant filters is reached, and the
// sharing is exact.
//
// Weights are kept as parameters [output field][input field][orbit] and expanded to a dense filter
// [input channel][tap][output channel] once an optimiser's step. Channel k of field f is channel k * fields +
// f.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learned/groups/group.hpp"
#include "learned/kernels/kernels.hpp"

namespace praxis::learned {

/// So many fields of a representation.
struct Fields {
    Representation representation;
    int count = 1;
    int channels() const { return representation.size * count; }
};

class SharedFilter {
  public:
    SharedFilter() = default;
    SharedFilter(const Group& group, const Fields& input, const Fields& output, int radius);

    std::size_t parameters() const { return parameters_; }
    std::size_t dense_size() const { return parameter_of_.size(); }
    int inputs() const { return inputs_; }
    int outputs() const { return outputs_; }
    int radius() const { return radius_; }
    ConvolutionShape shape(int height, int width) const {
        return {height, width, radius_, inputs_, outputs_};
    }

    /// Free weights that one output sees: the fan-in for initial values.
    int fan_in() const { return inputs_ * taps(); }

    template <class T>
    void expand(std::span<const T> parameters, std::span<T> dense) const {
        for (std::size_t i = 0; i < dense.size(); ++i) dense[i] = parameters[parameter_of_[i]];
    }
    /// gradient of the parameters += what the gradient of the dense filter says.
    template <class T>
    void gather(std::span<const T> of_dense, std::span<T> of_parameters) const {
        for (std::size_t i = 0; i < of_dense.size(); ++i) of_parameters[parameter_of_[i]] += of_dense[i];
    }
    /// The dense filter that maps back, [output][tap reversed][input]: a convolution with it is the gradient
    /// of the input.
    template <class T>
    void transpose(std::span<const T> dense, std::span<T> transposed) const {
        for (int i = 0; i < inputs_; ++i)
            for (int t = 0; t < taps(); ++t)
                for (int o = 0; o < outputs_; ++o)
                    transposed[static_cast<std::size_t>((o * taps() + taps() - 1 - t) * inputs_ + i)] =
                        dense[static_cast<std::size_t>((i * taps() + t) * outputs_ + o)];
    }
    /// Scales each output field whose weights have an L1 norm above `bound` down to it. All channels of an
    /// output field have the same norm, so that sharing survives. Afterwards the maximum over outputs of a
    /// filtered field is Lipschitz in the supremum norm with constant `bound`.
    template <class T>
    void bound_norm(std::span<T> parameters, T bound) const;

  private:
    int taps() const { return (2 * radius_ + 1) * (2 * radius_ + 1); }

    int inputs_ = 0, outputs_ = 0, radius_ = 0;
    int input_fields_ = 0, output_fields_ = 0, orbits_ = 0;
    std::size_t parameters_ = 0;
    std::vector<std::uint32_t> parameter_of_;  // of each dense weight
};

}  // namespace praxis::learned
