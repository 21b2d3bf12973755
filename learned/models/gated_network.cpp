#include "learned/models/gated_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "learned/layers/fixed_point.hpp"

namespace praxis::learned {

template <class T>
struct GatedNetwork<T>::Step {
    Planes<T> h;                         // before, padded
    std::array<Planes<T>, kGates> gate;  // after their nonlinearities
    Planes<T> reset;                     // r h, padded
};

template <class T>
struct GatedNetwork<T>::Memory final : Trace<T> {
    std::array<Planes<T>, kGates> input_of, of_input, of_gate;
    std::vector<Step> steps;
    Planes<T> blank;  // a state of zeros, of the right size
    Planes<T> of_h, of_next, of_reset;
    std::vector<T> scratch;

    Step& step(int k) {
        while (static_cast<int>(steps.size()) <= k) steps.push_back({blank, {blank, blank, blank}, blank});
        return steps[static_cast<std::size_t>(k)];
    }
};

template <class T>
GatedNetwork<T>::GatedNetwork(const PlannerOptions& options, std::uint64_t seed)
    : Planner<T>(options), group_(options.group) {
    using Layer = Convolution<T>;
    const Fields input{trivial(group_), kInputs}, state{regular(group_), options.fields},
        actions{moves(group_), 1};
    const auto layer = [&](const std::string& name, const Fields& from, const Fields& to, int radius,
                           auto bias) { return Layer(this->layout_, name, group_, from, to, radius, bias); };
    constexpr std::array kNames{"update", "reset", "candidate"};
    start_ = layer("start", input, state, options.input_radius, Layer::Bias::yes);
    for (std::size_t g = 0; g < kGates; ++g) {
        const std::string name = kNames[g];
        input_[g] = layer(name + ".input", input, state, options.input_radius, Layer::Bias::yes);
        hidden_[g] = layer(name + ".hidden", state, state, options.radius, Layer::Bias::no);
    }
    head_ = layer("head", state, actions, 0, Layer::Bias::no);
    this->parameters_.resize(this->layout_.size());
    Random random(seed);
    for (const Layer* one :
         {&start_, &input_[0], &input_[1], &input_[2], &hidden_[0], &hidden_[1], &hidden_[2], &head_})
        one->initialise(this->parameters_, random, 1);
    update();
}

template <class T>
void GatedNetwork<T>::update() {
    for (Convolution<T>* layer :
         {&start_, &input_[0], &input_[1], &input_[2], &hidden_[0], &hidden_[1], &hidden_[2], &head_})
        layer->update(this->parameters_);
}

template <class T>
std::unique_ptr<Trace<T>> GatedNetwork<T>::trace(int height, int width) const {
    auto memory = std::make_unique<Memory>();
    memory->input = Planes<T>(kInputs, height, width, this->options_.input_radius);
    memory->policy = memory->of_policy = Planes<T>(static_cast<int>(kMoves.size()), height, width, 0);
    memory->blank = Planes<T>(start_.outputs(), height, width, this->options_.radius);
    memory->values = memory->of_h = memory->of_next = memory->of_reset = memory->blank;
    memory->input_of.fill(memory->blank);
    memory->of_input = memory->of_gate = memory->input_of;
    return memory;
}

template <class T>
void GatedNetwork<T>::read(Memory& memory) const {
    memory.input.pad(this->options_.padding);
    for (std::size_t g = 0; g < kGates; ++g) {
        input_[g].start(memory.input_of[g]);
        input_[g].add(memory.input, memory.input_of[g]);
    }
    Planes<T>& h = memory.step(0).h;
    start_.start(h);
    start_.add(memory.input, h);
    kernels<T>().tanh(h.data(), h.size());
    h.pad(this->options_.padding);
}

template <class T>
void GatedNetwork<T>::advance(const Memory& memory, Step& step, Planes<T>& next) const {
    const std::size_t size = step.h.size();
    const Kernels<T>& k = kernels<T>();
    for (const Gate g : {update_gate, reset_gate}) {
        std::copy_n(memory.input_of[g].data(), size, step.gate[g].data());
        hidden_[g].add(step.h, step.gate[g]);
        k.sigmoid(step.gate[g].data(), size);
    }
    const T *h = step.h.data(), *r = step.gate[reset_gate].data();
    T* reset = step.reset.data();
    for (std::size_t i = 0; i < size; ++i) reset[i] = r[i] * h[i];
    step.reset.pad(this->options_.padding);
    std::copy_n(memory.input_of[candidate].data(), size, step.gate[candidate].data());
    hidden_[candidate].add(step.reset, step.gate[candidate]);
    k.tanh(step.gate[candidate].data(), size);
    const T *z = step.gate[update_gate].data(), *n = step.gate[candidate].data();
    T* to = next.data();
    for (std::size_t i = 0; i < size; ++i) to[i] = h[i] + z[i] * (n[i] - h[i]);
    next.pad(this->options_.padding);
}

template <class T>
void GatedNetwork<T>::iterate(Memory& memory, bool keep) const {
    const int steps = this->options_.iterations;
    memory.step(keep ? steps : 1);
    for (int k = 0; k < steps; ++k) {
        Step& step = memory.step(keep ? k : k % 2);
        advance(memory, step, memory.step(keep ? k + 1 : (k + 1) % 2).h);
    }
    memory.values = memory.step(keep ? steps : steps % 2).h;
    memory.iterations = steps;
}

template <class T>
void GatedNetwork<T>::solve(Memory& memory) const {
    memory.step(1);
    int k = 0;
    for (bool moving = true; moving && k < this->options_.iterations; ++k) {
        Step& step = memory.step(k % 2);
        Planes<T>& next = memory.step((k + 1) % 2).h;
        advance(memory, step, next);
        T largest = 0;
        for (std::size_t i = 0; i < next.size(); ++i)
            largest = std::max(largest, std::abs(next.data()[i] - step.h.data()[i]));
        memory.residual = static_cast<double>(largest);
        moving = memory.residual > this->options_.tolerance;
    }
    memory.values = memory.step(k % 2).h;
    memory.iterations = k;
}

template <class T>
void GatedNetwork<T>::plan(Trace<T>& trace) const {
    Memory& memory = static_cast<Memory&>(trace);
    read(memory);
    if (this->options_.differentiation == Differentiation::implicit)
        solve(memory);
    else
        iterate(memory, false);
    head_.start(memory.policy);
    head_.add(memory.values, memory.policy);
}

template <class T>
void GatedNetwork<T>::record(Trace<T>& trace) const {
    if (this->options_.differentiation == Differentiation::implicit) return plan(trace);
    Memory& memory = static_cast<Memory&>(trace);
    read(memory);
    iterate(memory, true);
    head_.start(memory.policy);
    head_.add(memory.values, memory.policy);
}

template <class T>
void GatedNetwork<T>::step_back(Memory& memory, const Step& step, const Planes<T>& of_next,
                                std::span<T> gradient) const {
    const std::size_t size = of_next.size();
    const T *z = step.gate[update_gate].data(), *r = step.gate[reset_gate].data(),
            *n = step.gate[candidate].data(), *h = step.h.data(), *of = of_next.data();
    T *of_z = memory.of_gate[update_gate].data(), *of_r = memory.of_gate[reset_gate].data(),
      *of_n = memory.of_gate[candidate].data(), *of_h = memory.of_h.data();
    for (std::size_t i = 0; i < size; ++i) {
        of_n[i] = of[i] * z[i] * (1 - n[i] * n[i]);
        of_z[i] = of[i] * (n[i] - h[i]) * z[i] * (1 - z[i]);
        of_h[i] = of[i] * (1 - z[i]);
    }
    const auto finish = [&](Gate g, const Planes<T>& input, Planes<T>& of_input) {
        Planes<T>& of_gate = memory.of_gate[g];
        if (!gradient.empty()) {
            hidden_[g].add_gradient(input, of_gate, gradient, memory.scratch);
            for (std::size_t i = 0; i < size; ++i) memory.of_input[g].data()[i] += of_gate.data()[i];
        }
        if (this->options_.padding != Padding::zero) of_gate.pad(this->options_.padding);
        hidden_[g].add_transposed(of_gate, of_input);
    };
    memory.of_reset.clear();
    finish(candidate, step.reset, memory.of_reset);
    const T* of_reset = memory.of_reset.data();
    for (std::size_t i = 0; i < size; ++i) {
        of_r[i] = of_reset[i] * h[i] * r[i] * (1 - r[i]);
        of_h[i] += of_reset[i] * r[i];
    }
    finish(update_gate, step.h, memory.of_h);
    finish(reset_gate, step.h, memory.of_h);
}

template <class T>
void GatedNetwork<T>::differentiate_fixed_point(Memory& memory, std::span<T> gradient) const {
    Step& step = memory.step(0);
    step.h = memory.values;
    advance(memory, step, memory.step(1).h);
    const Planes<T> of_fixed_point = memory.of_next;
    AdjointSolver<T> solver(this->options_.anderson, this->options_.backward_iterations, 1e-6);
    const std::span<T> solution(memory.of_next.data(), memory.of_next.size());
    Planes<T> point = memory.of_next;
    const AdjointResult found = solver.solve(solution, [&](std::span<const T> u, std::span<T> image) {
        std::ranges::copy(u, point.data());
        step_back(memory, step, point, {});
        for (std::size_t i = 0; i < image.size(); ++i)
            image[i] = memory.of_h.data()[i] + of_fixed_point.data()[i];
    });
    memory.backward_iterations = found.iterations;
    memory.backward_residual = found.residual;
    step_back(memory, step, memory.of_next, gradient);
}

template <class T>
void GatedNetwork<T>::differentiate(Trace<T>& trace, std::span<T> gradient) const {
    Memory& memory = static_cast<Memory&>(trace);
    for (Planes<T>& of_input : memory.of_input) of_input.clear();
    head_.add_gradient(memory.values, memory.of_policy, gradient, memory.scratch);
    memory.of_next.clear();
    head_.add_transposed(memory.of_policy, memory.of_next);
    if (this->options_.differentiation == Differentiation::implicit) {
        differentiate_fixed_point(memory, gradient);
    } else {
        for (int k = memory.iterations; k-- > 0;) {
            step_back(memory, memory.step(k), memory.of_next, gradient);
            std::swap(memory.of_h, memory.of_next);
        }
        const T* h = memory.step(0).h.data();
        for (std::size_t i = 0; i < memory.of_next.size(); ++i) memory.of_next.data()[i] *= 1 - h[i] * h[i];
        start_.add_gradient(memory.input, memory.of_next, gradient, memory.scratch);
    }
    for (std::size_t g = 0; g < kGates; ++g)
        input_[g].add_gradient(memory.input, memory.of_input[g], gradient, memory.scratch);
}

template class GatedNetwork<float>;
template class GatedNetwork<double>;

}  // namespace praxis::learned
