// Adam (Kingma and Ba, ICLR 2015) with decoupled weight decay (Loshchilov and Hutter, ICLR 2019).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace praxis::practice {

class Adam {
  public:
    /// For so many weights.
    explicit Adam(std::size_t weights) : mean_(weights), square_(weights) {}
    /// One step down the gradient; besides, each weight shrinks by the factor 1 - rate * decay.
    void step(std::span<float> weights, std::span<const float> gradient, float rate, float decay);

  private:
    std::vector<float> mean_, square_;
    double mean_factor_ = 1, square_factor_ = 1;  // beta1^t, beta2^t
};

}  // namespace praxis::practice
