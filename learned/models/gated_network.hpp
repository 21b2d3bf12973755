// ConvGPPN, and with a group SymGPPN (Zhao et al., ICLR 2023): gated path planning with a convolutional GRU.
//
//     z, r = sigmoid(X + filter(h)),  n = tanh(X + filter(r h)),  h <- (1 - z) h + z n,  K times,  policy =
//     head(h)
//
// X = filter(map, goal) differs for each gate and is computed once: it is injected into every iteration, so
// that a fixed point depends on the map and not on the start, h = tanh(filter(map, goal)). All filters share
// their weights under the group; gates act on each channel alone, which commutes with its permutations.
//
// A GRU is not a contraction. An implicit one tells its residuals (Trace), so that the caller can see whether
// there was a fixed point.
#pragma once

#include <array>

#include "learned/layers/convolution.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

template <class T>
class GatedNetwork final : public Planner<T> {
  public:
    GatedNetwork(const PlannerOptions& options, std::uint64_t seed);

    void update() override;
    std::unique_ptr<Trace<T>> trace(int height, int width) const override;
    void plan(Trace<T>& trace) const override;
    void record(Trace<T>& trace) const override;
    void differentiate(Trace<T>& trace, std::span<T> gradient) const override;

  private:
    enum Gate : std::uint8_t { update_gate, reset_gate, candidate };
    static constexpr std::size_t kGates = 3;
    struct Step;
    struct Memory;

    void read(Memory& memory) const;
    /// From step.h to `next`, which is padded.
    void advance(const Memory& memory, Step& step, Planes<T>& next) const;
    void iterate(Memory& memory, bool keep) const;
    void solve(Memory& memory) const;
    /// memory.of_h = the gradient of step.h, given that of the result; with `gradient`, the parameters' too.
    void step_back(Memory& memory, const Step& step, const Planes<T>& of_next, std::span<T> gradient) const;
    void differentiate_fixed_point(Memory& memory, std::span<T> gradient) const;

    Group group_;
    Convolution<T> start_, head_;
    std::array<Convolution<T>, kGates> input_, hidden_;
};

}  // namespace praxis::learned
