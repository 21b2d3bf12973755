// Steps down a gradient: RMSprop (Tieleman and Hinton, 2012) and Adam (Kingma and Ba, ICLR 2015), after
// clipping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace praxis::learned {

enum class Method : std::uint8_t { rmsprop, adam };

struct OptimizerOptions {
    Method method = Method::adam;
    double clip = 5;          ///< bound on the gradient's Euclidean norm; 0 is none
    double smoothing = 0.99;  ///< RMSprop's
    double epsilon = 1e-6;
};

/// The Euclidean norm, before the gradient is scaled so that it is at most `bound` (0: no bound).
template <class T>
double clip_norm(std::span<T> gradient, double bound);

template <class T>
class Optimizer {
  public:
    Optimizer(OptimizerOptions options, std::size_t parameters)
        : options_(options), mean_(options.method == Method::adam ? parameters : 0), square_(parameters) {}

    /// Clips the gradient and takes a step. A gradient that is not finite is refused: nothing changes, false
    /// is returned.
    bool step(std::span<T> parameters, std::span<T> gradient, double rate);

    /// What a checkpoint keeps.
    std::vector<T>& mean() { return mean_; }
    std::vector<T>& square() { return square_; }
    std::uint64_t steps() const { return steps_; }
    void set_steps(std::uint64_t steps) { steps_ = steps; }

  private:
    OptimizerOptions options_;
    std::vector<T> mean_, square_;
    std::uint64_t steps_ = 0;
};

}  // namespace praxis::learned
