// A convolution between fields of a group, its gradients, and its place among the parameters of a model.
//
// The dense weights that the parameters stand for are kept here; update() renews them whenever the parameters
// have changed. Everything else is const and may run on several threads, each with planes and a Scratch of
// its own.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "learned/groups/shared_filter.hpp"
#include "learned/kernels/planes.hpp"
#include "learned/layers/parameters.hpp"
#include "search/engines/random.hpp"

namespace praxis::learned {

template <class T>
class Convolution {
  public:
    enum class Bias : bool { no, yes };

    Convolution() = default;
    Convolution(ParameterLayout& layout, const std::string& name, const Group& group, const Fields& input,
                const Fields& output, int radius, Bias bias);

    const SharedFilter& shared() const { return shared_; }
    int radius() const { return shared_.radius(); }
    int outputs() const { return shared_.outputs(); }
    /// [input][tap][output].
    std::span<const T> dense() const { return dense_; }
    /// [output][tap reversed][input].
    std::span<const T> transposed() const { return transposed_; }

    /// Uniform weights of variance gain^2 / fan-in, no bias.
    void initialise(std::span<T> parameters, Random& random, double gain) const;
    /// See SharedFilter::bound_norm.
    void bound_norm(std::span<T> parameters, T bound) const;
    void update(std::span<const T> parameters);

    /// output = bias (behind the map: anything).
    void start(Planes<T>& output) const;
    /// output += filter(input); the input is padded.
    void add(const Planes<T>& input, Planes<T>& output) const;
    /// of_input += the gradient of the input; `of_output` is padded as the input was.
    void add_transposed(const Planes<T>& of_output, Planes<T>& of_input) const;

    /// gradient += the gradient of the parameters, where `of_output` has an empty halo.
    void add_gradient(const Planes<T>& input, const Planes<T>& of_output, std::span<T> gradient,
                      std::vector<T>& scratch) const;
    /// The filter's part of it, for a dense gradient known already.
    void gather(std::span<const T> of_dense, std::span<T> gradient) const;

  private:
    void add_bias_gradient(const Planes<T>& of_output, std::span<T> gradient) const;

    SharedFilter shared_;
    int output_fields_ = 0;
    ParameterBlock filter_, bias_;
    std::vector<T> dense_, transposed_, biases_;
};

}  // namespace praxis::learned
