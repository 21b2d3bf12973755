#include "learned/layers/convolution.hpp"

#include <algorithm>
#include <cmath>

#include "learned/layers/uniform.hpp"

namespace praxis::learned {

template <class T>
Convolution<T>::Convolution(ParameterLayout& layout, const std::string& name, const Group& group,
                            const Fields& input, const Fields& output, int radius, Bias bias)
    : shared_(group, input, output, radius),
      output_fields_(output.count),
      filter_(layout.add(name, shared_.parameters())),
      dense_(shared_.dense_size()),
      transposed_(shared_.dense_size()) {
    if (bias == Bias::no) return;
    bias_ = layout.add(name + ".bias", static_cast<std::size_t>(output.count));
    biases_.resize(bias_.size);
}

template <class T>
void Convolution<T>::initialise(std::span<T> parameters, Random& random, double gain) const {
    const double bound = gain * std::sqrt(3.0 / shared_.fan_in());
    for (T& weight : filter_.of(parameters)) weight = static_cast<T>(uniform(random, -bound, bound));
    std::ranges::fill(bias_.of(parameters), T(0));
}

template <class T>
void Convolution<T>::bound_norm(std::span<T> parameters, T bound) const {
    shared_.bound_norm(filter_.of(parameters), bound);
}

template <class T>
void Convolution<T>::update(std::span<const T> parameters) {
    shared_.expand(filter_.of(parameters), std::span<T>(dense_));
    shared_.transpose(std::span<const T>(dense_), std::span<T>(transposed_));
    std::ranges::copy(bias_.of(parameters), biases_.begin());
}

template <class T>
void Convolution<T>::start(Planes<T>& output) const {
    for (int channel = 0; channel < output.channels(); ++channel) {
        const T value = biases_.empty() ? T(0) : biases_[static_cast<std::size_t>(channel % output_fields_)];
        for (int row = 0; row < output.height(); ++row)
            std::fill_n(&output.at(channel, row, 0), output.width(), value);
    }
}

template <class T>
void Convolution<T>::add(const Planes<T>& input, Planes<T>& output) const {
    kernels<T>().convolve(shared_.shape(output.height(), output.width()), input.view(), dense_.data(),
                          output.view());
}

template <class T>
void Convolution<T>::add_transposed(const Planes<T>& of_output, Planes<T>& of_input) const {
    const ConvolutionShape shape{of_input.height(), of_input.width(), shared_.radius(), shared_.outputs(),
                                 shared_.inputs()};
    kernels<T>().convolve(shape, of_output.view(), transposed_.data(), of_input.view());
}

template <class T>
void Convolution<T>::add_gradient(const Planes<T>& input, const Planes<T>& of_output, std::span<T> gradient,
                                  std::vector<T>& scratch) const {
    scratch.assign(dense_.size(), T(0));
    kernels<T>().convolve_gradient(shared_.shape(of_output.height(), of_output.width()), input.view(),
                                   of_output.view(), scratch.data());
    gather(scratch, gradient);
    add_bias_gradient(of_output, gradient);
}

template <class T>
void Convolution<T>::gather(std::span<const T> of_dense, std::span<T> gradient) const {
    shared_.gather(of_dense, filter_.of(gradient));
}

template <class T>
void Convolution<T>::add_bias_gradient(const Planes<T>& of_output, std::span<T> gradient) const {
    if (biases_.empty()) return;
    const std::span<T> of_bias = bias_.of(gradient);
    for (int channel = 0; channel < of_output.channels(); ++channel)
        for (int row = 0; row < of_output.height(); ++row) {
            const T* const cells = &of_output.at(channel, row, 0);
            T sum = 0;
            for (int column = 0; column < of_output.width(); ++column) sum += cells[column];
            of_bias[static_cast<std::size_t>(channel % output_fields_)] += sum;
        }
}

template class Convolution<float>;
template class Convolution<double>;

}  // namespace praxis::learned
