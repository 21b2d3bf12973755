#include "learned/models/lstm_network.hpp"

#include <algorithm>
#include <utility>

namespace praxis::learned {

template <class T>
struct LstmNetwork<T>::Step {
    Planes<T> h, c;                      // before; h is padded
    Planes<T> u, squashed;               // of the neighbours; tanh of the next c
    std::array<Planes<T>, kGates> gate;  // after their nonlinearities
};

template <class T>
struct LstmNetwork<T>::Memory final : Trace<T> {
    std::vector<Step> steps;
    Planes<T> blank, blank_u;  // zeros of the right size
    Planes<T> of_h, of_c, of_next, of_u;
    std::array<Planes<T>, kGates> of_gate;
    std::vector<T> scratch;

    Step& step(int k) {
        while (static_cast<int>(steps.size()) <= k)
            steps.push_back({blank, blank, blank_u, blank, {blank, blank, blank, blank}});
        return steps[static_cast<std::size_t>(k)];
    }
};

template <class T>
template <class Visit>
void LstmNetwork<T>::for_layers(const Visit& visit) {
    for (Convolution<T>* layer : {&start_h_, &start_c_, &neighbours_, &head_}) visit(*layer);
    for (std::size_t g = 0; g < kGates; ++g) {
        visit(from_neighbours_[g]);
        visit(from_h_[g]);
    }
}

template <class T>
LstmNetwork<T>::LstmNetwork(const PlannerOptions& options, std::uint64_t seed)
    : Planner<T>(options), group_(options.group) {
    using Layer = Convolution<T>;
    const Fields input{trivial(group_), kInputs}, state{regular(group_), options.fields},
        one{regular(group_), 1}, actions{moves(group_), 1};
    const auto layer = [&](const std::string& name, const Fields& from, const Fields& to, int radius,
                           auto bias) { return Layer(this->layout_, name, group_, from, to, radius, bias); };
    start_h_ = layer("start.h", input, state, options.input_radius, Layer::Bias::yes);
    start_c_ = layer("start.c", input, state, options.input_radius, Layer::Bias::yes);
    neighbours_ = layer("neighbours", state, one, options.radius, Layer::Bias::yes);
    constexpr std::array kNames{"input", "forget", "output", "candidate"};
    for (std::size_t g = 0; g < kGates; ++g) {
        const std::string name = kNames[g];
        from_neighbours_[g] = layer(name + ".neighbours", one, state, 0, Layer::Bias::yes);
        from_h_[g] = layer(name + ".h", state, state, 0, Layer::Bias::no);
    }
    head_ = layer("head", state, actions, 0, Layer::Bias::no);
    this->parameters_.resize(this->layout_.size());
    Random random(seed);
    for_layers([&](Layer& each) { each.initialise(this->parameters_, random, 1); });
    update();
}

template <class T>
void LstmNetwork<T>::update() {
    for_layers([&](Convolution<T>& layer) { layer.update(this->parameters_); });
}

template <class T>
std::unique_ptr<Trace<T>> LstmNetwork<T>::trace(int height, int width) const {
    auto memory = std::make_unique<Memory>();
    memory->input = Planes<T>(kInputs, height, width, this->options_.input_radius);
    memory->policy = memory->of_policy = Planes<T>(static_cast<int>(kMoves.size()), height, width, 0);
    memory->blank = Planes<T>(start_h_.outputs(), height, width, this->options_.radius);
    memory->blank_u = memory->of_u = Planes<T>(group_.order(), height, width, this->options_.radius);
    memory->values = memory->of_h = memory->of_c = memory->of_next = memory->blank;
    memory->of_gate.fill(memory->blank);
    return memory;
}

template <class T>
void LstmNetwork<T>::advance(Step& step, Step& next) const {
    const std::size_t size = step.h.size();
    const Kernels<T>& k = kernels<T>();
    neighbours_.start(step.u);
    neighbours_.add(step.h, step.u);
    for (std::size_t g = 0; g < kGates; ++g) {
        from_neighbours_[g].start(step.gate[g]);
        from_neighbours_[g].add(step.u, step.gate[g]);
        from_h_[g].add(step.h, step.gate[g]);
        (g == candidate ? k.tanh : k.sigmoid)(step.gate[g].data(), size);
    }
    const T *in = step.gate[input_gate].data(), *forget = step.gate[forget_gate].data(),
            *out = step.gate[output_gate].data(), *fresh = step.gate[candidate].data(), *c = step.c.data();
    T *next_c = next.c.data(), *squashed = step.squashed.data(), *next_h = next.h.data();
    for (std::size_t i = 0; i < size; ++i) squashed[i] = next_c[i] = forget[i] * c[i] + in[i] * fresh[i];
    k.tanh(squashed, size);
    for (std::size_t i = 0; i < size; ++i) next_h[i] = out[i] * squashed[i];
    next.h.pad(this->options_.padding);
}

template <class T>
void LstmNetwork<T>::iterate(Memory& memory, bool keep) const {
    const int steps = this->options_.iterations;
    const auto step = [&](int k) -> Step& { return memory.step(keep ? k : k % 2); };
    memory.step(keep ? steps : 1);
    memory.input.pad(this->options_.padding);
    start_h_.start(step(0).h);
    start_h_.add(memory.input, step(0).h);
    step(0).h.pad(this->options_.padding);
    start_c_.start(step(0).c);
    start_c_.add(memory.input, step(0).c);
    for (int k = 0; k < steps; ++k) advance(step(k), step(k + 1));
    memory.values = step(steps).h;
    memory.iterations = steps;
    head_.start(memory.policy);
    head_.add(memory.values, memory.policy);
}

template <class T>
void LstmNetwork<T>::plan(Trace<T>& trace) const {
    iterate(static_cast<Memory&>(trace), false);
}

template <class T>
void LstmNetwork<T>::record(Trace<T>& trace) const {
    iterate(static_cast<Memory&>(trace), true);
}

template <class T>
void LstmNetwork<T>::step_back(Memory& memory, const Step& step, std::span<T> gradient) const {
    const std::size_t size = step.h.size();
    const T *in = step.gate[input_gate].data(), *forget = step.gate[forget_gate].data(),
            *out = step.gate[output_gate].data(), *fresh = step.gate[candidate].data(), *c = step.c.data(),
            *squashed = step.squashed.data(), *of_next = memory.of_next.data();
    T *of_in = memory.of_gate[input_gate].data(), *of_forget = memory.of_gate[forget_gate].data(),
      *of_out = memory.of_gate[output_gate].data(), *of_fresh = memory.of_gate[candidate].data(),
      *of_c = memory.of_c.data();
    for (std::size_t i = 0; i < size; ++i) {
        const T of = of_c[i] + of_next[i] * out[i] * (1 - squashed[i] * squashed[i]);
        of_out[i] = of_next[i] * squashed[i] * out[i] * (1 - out[i]);
        of_in[i] = of * fresh[i] * in[i] * (1 - in[i]);
        of_forget[i] = of * c[i] * forget[i] * (1 - forget[i]);
        of_fresh[i] = of * in[i] * (1 - fresh[i] * fresh[i]);
        of_c[i] = of * forget[i];
    }
    memory.of_h.clear();
    memory.of_u.clear();
    for (std::size_t g = 0; g < kGates; ++g) {
        from_neighbours_[g].add_gradient(step.u, memory.of_gate[g], gradient, memory.scratch);
        from_h_[g].add_gradient(step.h, memory.of_gate[g], gradient, memory.scratch);
        from_neighbours_[g].add_transposed(memory.of_gate[g], memory.of_u);
        from_h_[g].add_transposed(memory.of_gate[g], memory.of_h);
    }
    neighbours_.add_gradient(step.h, memory.of_u, gradient, memory.scratch);
    memory.of_u.pad(this->options_.padding);
    neighbours_.add_transposed(memory.of_u, memory.of_h);
}

template <class T>
void LstmNetwork<T>::differentiate(Trace<T>& trace, std::span<T> gradient) const {
    Memory& memory = static_cast<Memory&>(trace);
    head_.add_gradient(memory.values, memory.of_policy, gradient, memory.scratch);
    memory.of_next.clear();
    memory.of_c.clear();
    head_.add_transposed(memory.of_policy, memory.of_next);
    for (int k = memory.iterations; k-- > 0;) {
        step_back(memory, memory.step(k), gradient);
        std::swap(memory.of_h, memory.of_next);
    }
    start_h_.add_gradient(memory.input, memory.of_next, gradient, memory.scratch);
    start_c_.add_gradient(memory.input, memory.of_c, gradient, memory.scratch);
}

template class LstmNetwork<float>;
template class LstmNetwork<double>;

}  // namespace praxis::learned
