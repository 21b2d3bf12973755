#include "learned/models/value_iteration_network.hpp"

#include <algorithm>
#include <cmath>

#include "learned/kernels/row_pairs.hpp"
#include "learned/layers/fixed_point.hpp"

namespace praxis::learned {

template <class T>
struct ValueIterationNetwork<T>::Memory final : Trace<T> {
    Planes<T> rewards, of_rewards, q, of_q;
    std::vector<Planes<T>> values;                // of each iteration, as far as kept
    std::vector<std::vector<std::uint8_t>> best;  // maximisers of each iteration
    Planes<T> of_values;
    Interleaved<T> values_by_cell, of_result, of_previous;
    std::vector<T> of_turned, of_dense, scratch, row_sums;

    Planes<T>& values_at(int k, int order, int height, int width, int halo) {
        while (static_cast<int>(values.size()) <= k) values.emplace_back(order, height, width, halo);
        return values[static_cast<std::size_t>(k)];
    }
    std::uint8_t* best_at(int k) {
        while (static_cast<int>(best.size()) <= k)
            best.emplace_back(static_cast<std::size_t>(rewards.plane()) *
                                  static_cast<std::size_t>(of_values.channels()) +
                              kRowUnit);
        return best[static_cast<std::size_t>(k)].data();
    }
};

template <class T>
ValueIterationNetwork<T>::ValueIterationNetwork(const PlannerOptions& options, std::uint64_t seed)
    : Planner<T>(options), group_(options.group) {
    using Layer = Convolution<T>;
    const Fields input{trivial(group_), kInputs}, q{regular(group_), options.fields}, v{regular(group_), 1},
        actions{moves(group_), 1};
    reward_ = Layer(this->layout_, "reward", group_, input, q, options.input_radius, Layer::Bias::yes);
    value_ = Layer(this->layout_, "value", group_, v, q, options.radius, Layer::Bias::no);
    head_ = Layer(this->layout_, "head", group_, q, actions, 0, Layer::Bias::no);
    this->parameters_.resize(this->layout_.size());
    turned_.resize(value_.dense().size());
    Random random(seed);
    reward_.initialise(this->parameters_, random, 1);
    value_.initialise(this->parameters_, random, 1);
    head_.initialise(this->parameters_, random, 1);
    update();
}

template <class T>
void ValueIterationNetwork<T>::update() {
    if (this->options_.contraction > 0)
        value_.bound_norm(this->parameters_, static_cast<T>(this->options_.contraction));
    for (Convolution<T>* layer : {&reward_, &value_, &head_}) layer->update(this->parameters_);
    const int taps = value_.shared().shape(0, 0).taps(), order = group_.order();
    if (order > 1 && this->options_.radius == 1)
        pair_filter(order, value_.outputs(), value_.dense(), paired_);
    for (int o = 0; o < value_.outputs(); ++o)
        for (int t = 0; t < taps; ++t)
            for (int i = 0; i < order; ++i)
                turned_[static_cast<std::size_t>((o * taps + t) * order + i)] =
                    value_.dense()[static_cast<std::size_t>((i * taps + t) * value_.outputs() + o)];
}

template <class T>
std::unique_ptr<Trace<T>> ValueIterationNetwork<T>::trace(int height, int width) const {
    auto memory = std::make_unique<Memory>();
    const int halo = this->options_.radius, channels = value_.outputs(), order = group_.order();
    memory->input = Planes<T>(kInputs, height, width, this->options_.input_radius);
    memory->rewards = memory->of_rewards = memory->q = Planes<T>(channels, height, width, 0);
    memory->of_q = Planes<T>(channels, height, width, halo);
    memory->policy = memory->of_policy = Planes<T>(static_cast<int>(kMoves.size()), height, width, 0);
    memory->Trace<T>::values = memory->of_values = Planes<T>(order, height, width, halo);
    memory->values_by_cell = memory->of_result = memory->of_previous =
        Interleaved<T>(order, height, width, halo);
    memory->of_turned.resize(value_.dense().size());
    memory->of_dense.resize(value_.dense().size());
    if (!paired_.empty())
        memory->row_sums.resize(row_pair_scratch(shape(*memory), memory->of_values.stride()));
    return memory;
}

template <class T>
BackupShape ValueIterationNetwork<T>::shape(const Memory& memory) const {
    return {memory.rewards.height(), memory.rewards.width(), this->options_.radius, group_.order(),
            this->options_.fields};
}

template <class T>
void ValueIterationNetwork<T>::read_rewards(Memory& memory) const {
    memory.input.pad(this->options_.padding);
    reward_.start(memory.rewards);
    reward_.add(memory.input, memory.rewards);
}

template <class T>
void ValueIterationNetwork<T>::back_up(Memory& memory, const Planes<T>& values, Planes<T>& result,
                                       std::uint8_t* best) const {
    if (paired_.empty())
        kernels<T>().backup(shape(memory), values.view(), value_.dense().data(), memory.rewards.view(),
                            result.view(), best);
    else
        kernels<T>().backup_by_pairs(shape(memory), values.view(), paired_.data(), memory.rewards.view(),
                                     result.view(), best, memory.row_sums.data());
    if (this->options_.padding != Padding::zero) result.pad(this->options_.padding);
}

template <class T>
void ValueIterationNetwork<T>::iterate(Memory& memory, bool keep) const {
    const int halo = this->options_.radius, order = group_.order();
    const auto values = [&](int k) -> Planes<T>& {
        return memory.values_at(keep ? k : k % 2, order, memory.rewards.height(), memory.rewards.width(),
                                halo);
    };
    const int steps = this->options_.iterations;
    memory.values_at(keep ? steps : 1, order, memory.rewards.height(), memory.rewards.width(), halo);
    values(0).clear();
    for (int k = 0; k < steps; ++k)
        back_up(memory, values(k), values(k + 1), keep ? memory.best_at(k) : nullptr);
    memory.Trace<T>::values = values(steps);
    memory.iterations = steps;
}

template <class T>
void ValueIterationNetwork<T>::solve(Memory& memory) const {
    const int halo = this->options_.radius, order = group_.order();
    const auto values = [&](int k) -> Planes<T>& {
        return memory.values_at(k % 2, order, memory.rewards.height(), memory.rewards.width(), halo);
    };
    values(1);
    values(0).clear();
    int k = 0;
    for (bool moving = true; moving && k < this->options_.iterations; ++k) {
        back_up(memory, values(k), values(k + 1), nullptr);
        T largest = 0;
        for (std::size_t i = 0; i < values(0).size(); ++i)
            largest = std::max(largest, std::abs(values(0).data()[i] - values(1).data()[i]));
        memory.residual = static_cast<double>(largest);
        moving = memory.residual > this->options_.tolerance;
    }
    memory.Trace<T>::values = values(k);
    memory.iterations = k;
}

template <class T>
void ValueIterationNetwork<T>::act(Memory& memory) const {
    std::ranges::copy(std::span<const T>(memory.rewards.data(), memory.rewards.size()), memory.q.data());
    value_.add(memory.Trace<T>::values, memory.q);
    head_.start(memory.policy);
    head_.add(memory.q, memory.policy);
}

template <class T>
void ValueIterationNetwork<T>::plan(Trace<T>& trace) const {
    Memory& memory = static_cast<Memory&>(trace);
    read_rewards(memory);
    if (this->options_.differentiation == Differentiation::implicit)
        solve(memory);
    else
        iterate(memory, false);
    act(memory);
}

template <class T>
void ValueIterationNetwork<T>::record(Trace<T>& trace) const {
    if (this->options_.differentiation == Differentiation::implicit) return plan(trace);
    Memory& memory = static_cast<Memory&>(trace);
    read_rewards(memory);
    iterate(memory, true);
    act(memory);
}

template <class T>
void ValueIterationNetwork<T>::differentiate_policy(Memory& memory, std::span<T> gradient) const {
    head_.add_gradient(memory.q, memory.of_policy, gradient, memory.scratch);
    memory.of_q.clear();
    head_.add_transposed(memory.of_policy, memory.of_q);
    for (int channel = 0; channel < memory.of_q.channels(); ++channel)
        for (int row = 0; row < memory.of_q.height(); ++row)
            std::copy_n(&memory.of_q.at(channel, row, 0), memory.of_q.width(),
                        &memory.of_rewards.at(channel, row, 0));
    value_.add_gradient(memory.Trace<T>::values, memory.of_q, gradient, memory.scratch);
    memory.of_q.pad(this->options_.padding);
    memory.of_values.clear();
    value_.add_transposed(memory.of_q, memory.of_values);
    memory.of_result.gather(memory.of_values);
}

template <class T>
void ValueIterationNetwork<T>::step_back(Memory& memory, const std::uint8_t* best,
                                         const Interleaved<T>& of_result, Interleaved<T>& of_values,
                                         bool weights) const {
    of_values.clear();
    kernels<T>().backup_gradient(shape(memory), memory.values_by_cell.view(), turned_.data(), best,
                                 of_result.view(), of_values.view(),
                                 weights ? memory.of_turned.data() : nullptr,
                                 weights ? memory.of_rewards.view()
                                         : View<T>{nullptr, memory.rewards.stride(), memory.rewards.plane()});
    of_values.fold(this->options_.padding);
}

template <class T>
void ValueIterationNetwork<T>::differentiate_iterations(Memory& memory) const {
    for (int k = memory.iterations; k-- > 0;) {
        memory.values_by_cell.gather(memory.values[static_cast<std::size_t>(k)]);
        step_back(memory, memory.best_at(k), memory.of_result, memory.of_previous, true);
        std::swap(memory.of_result, memory.of_previous);
    }
}

template <class T>
void ValueIterationNetwork<T>::differentiate_fixed_point(Memory& memory) const {
    std::uint8_t* const best = memory.best_at(0);
    Planes<T>& next = memory.values[static_cast<std::size_t>((memory.iterations + 1) % 2)];
    back_up(memory, memory.Trace<T>::values, next, best);
    memory.values_by_cell.gather(memory.Trace<T>::values);
    const std::vector<T> of_fixed_point = memory.of_result.cells();
    AdjointSolver<T> solver(this->options_.anderson, this->options_.backward_iterations, 1e-6);
    Interleaved<T> point = memory.of_result;
    const AdjointResult found =
        solver.solve(memory.of_result.cells(), [&](std::span<const T> u, std::span<T> image) {
            std::ranges::copy(u, point.cells().begin());
            step_back(memory, best, point, memory.of_previous, false);
            for (std::size_t i = 0; i < image.size(); ++i)
                image[i] = memory.of_previous.cells()[i] + of_fixed_point[i];
        });
    memory.backward_iterations = found.iterations;
    memory.backward_residual = found.residual;
    step_back(memory, best, memory.of_result, memory.of_previous, true);
}

template <class T>
void ValueIterationNetwork<T>::differentiate(Trace<T>& trace, std::span<T> gradient) const {
    Memory& memory = static_cast<Memory&>(trace);
    std::ranges::fill(memory.of_turned, T(0));
    differentiate_policy(memory, gradient);
    if (this->options_.differentiation == Differentiation::implicit)
        differentiate_fixed_point(memory);
    else
        differentiate_iterations(memory);
    const int taps = value_.shared().shape(0, 0).taps(), order = group_.order();
    for (int o = 0; o < value_.outputs(); ++o)
        for (int t = 0; t < taps; ++t)
            for (int i = 0; i < order; ++i)
                memory.of_dense[static_cast<std::size_t>((i * taps + t) * value_.outputs() + o)] =
                    memory.of_turned[static_cast<std::size_t>((o * taps + t) * order + i)];
    value_.gather(memory.of_dense, gradient);
    reward_.add_gradient(memory.input, memory.of_rewards, gradient, memory.scratch);
}

template class ValueIterationNetwork<float>;
template class ValueIterationNetwork<double>;

}  // namespace praxis::learned
