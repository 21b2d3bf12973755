// Gated path planning networks (Lee et al., ICML 2018): an LSTM at each cell, that sees its neighbours
// through one filter.
//
//     u = filter(h),  i, f, o = sigmoid(W u + U h),  g = tanh(W u + U h),  c <- f c + i g,  h <- o tanh(c),
//     K times
//
// W and U are matrices, the same at all cells; h and c start as filters of the map and the goal. With a
// group, u is one regular field and all of it is shared under the group.
#pragma once

#include <array>

#include "learned/layers/convolution.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

template <class T>
class LstmNetwork final : public Planner<T> {
  public:
    LstmNetwork(const PlannerOptions& options, std::uint64_t seed);

    void update() override;
    std::unique_ptr<Trace<T>> trace(int height, int width) const override;
    void plan(Trace<T>& trace) const override;
    void record(Trace<T>& trace) const override;
    void differentiate(Trace<T>& trace, std::span<T> gradient) const override;

  private:
    enum Gate : std::uint8_t { input_gate, forget_gate, output_gate, candidate };
    static constexpr std::size_t kGates = 4;
    struct Step;
    struct Memory;

    template <class Visit>
    void for_layers(const Visit& visit);
    void advance(Step& step, Step& next) const;
    void iterate(Memory& memory, bool keep) const;
    void step_back(Memory& memory, const Step& step, std::span<T> gradient) const;

    Group group_;
    Convolution<T> start_h_, start_c_, neighbours_, head_;
    std::array<Convolution<T>, kGates> from_neighbours_, from_h_;
};

}  // namespace praxis::learned
