// Value iteration networks (Tamar et al., NeurIPS 2016), and with a group the symmetric ones (Zhao et al.,
// ICLR 2023).
//
//     R = filter(map, goal),  V <- max over fields of (R + filter(V)), K times,  policy = head(R + filter(V))
//
// R and Q are regular fields of the group, V is one: the maximum is taken within each channel of the group.
// The head maps to the moves as the group turns them, so that the network is equivariant from end to end.
// Bounding the L1 norm of the iterated filter by gamma makes the iteration gamma-Lipschitz in the supremum
// norm: it cannot diverge, and below 1 it has exactly one fixed point, which is what implicit differentiation
// needs.
//
// Unrolled, the way back keeps V and the maximising field of each iteration; the gradient flows through that
// field alone, fields times fewer operations than a dense convolution.
#pragma once

#include "learned/kernels/interleaved.hpp"
#include "learned/layers/convolution.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

template <class T>
class ValueIterationNetwork final : public Planner<T> {
  public:
    ValueIterationNetwork(const PlannerOptions& options, std::uint64_t seed);

    void update() override;
    std::unique_ptr<Trace<T>> trace(int height, int width) const override;
    void plan(Trace<T>& trace) const override;
    void record(Trace<T>& trace) const override;
    void differentiate(Trace<T>& trace, std::span<T> gradient) const override;

  private:
    struct Memory;

    void read_rewards(Memory& memory) const;
    void act(Memory& memory) const;
    BackupShape shape(const Memory& memory) const;
    void back_up(Memory& memory, const Planes<T>& values, Planes<T>& result, std::uint8_t* best) const;
    void iterate(Memory& memory, bool keep) const;
    void solve(Memory& memory) const;
    /// memory.of_values, the gradient of the last values, and the gradients of head and of the last filter.
    void differentiate_policy(Memory& memory, std::span<T> gradient) const;
    void differentiate_iterations(Memory& memory) const;
    void differentiate_fixed_point(Memory& memory) const;
    /// One step back from `of_result` to `of_values`, with the maximisers of a step.
    void step_back(Memory& memory, const std::uint8_t* best, const Interleaved<T>& of_result,
                   Interleaved<T>& of_values, bool weights) const;

    Group group_;
    Convolution<T> reward_, value_, head_;
    std::vector<T> turned_;  // the filter as [output][tap][input]
    std::vector<T> paired_;  // the filter for pairs of rows, where they pay; else empty
};

}  // namespace praxis::learned
