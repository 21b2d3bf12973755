#include "learned/training/optimizer.hpp"

#include <cmath>

namespace praxis::learned {

template <class T>
double clip_norm(std::span<T> gradient, double bound) {
    double squares = 0;
    for (const T value : gradient) squares += static_cast<double>(value) * static_cast<double>(value);
    const double norm = std::sqrt(squares);
    if (bound > 0 && norm > bound) {
        const T factor = static_cast<T>(bound / norm);
        for (T& value : gradient) value *= factor;
    }
    return norm;
}

template <class T>
bool Optimizer<T>::step(std::span<T> parameters, std::span<T> gradient, double rate) {
    if (!std::isfinite(clip_norm(gradient, options_.clip))) return false;
    ++steps_;
    const T epsilon = static_cast<T>(options_.epsilon);
    if (options_.method == Method::rmsprop) {
        const T keep = static_cast<T>(options_.smoothing);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            square_[i] = keep * square_[i] + (1 - keep) * gradient[i] * gradient[i];
            parameters[i] -= static_cast<T>(rate) * gradient[i] / (std::sqrt(square_[i]) + epsilon);
        }
        return true;
    }
    constexpr T kMean = T(0.9), kSquare = T(0.999);
    const double count = static_cast<double>(steps_);
    const T of_mean = static_cast<T>(rate / (1 - std::pow(0.9, count)));
    const T of_square = static_cast<T>(1 / std::sqrt(1 - std::pow(0.999, count)));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        mean_[i] = kMean * mean_[i] + (1 - kMean) * gradient[i];
        square_[i] = kSquare * square_[i] + (1 - kSquare) * gradient[i] * gradient[i];
        parameters[i] -= of_mean * mean_[i] / (std::sqrt(square_[i]) * of_square + epsilon);
    }
    return true;
}

template double clip_norm(std::span<float>, double);
template double clip_norm(std::span<double>, double);
template class Optimizer<float>;
template class Optimizer<double>;

}  // namespace praxis::learned
