// What planning on one map costs with a network: 15x15 cells, 30 iterations, one core, from the map to the
// policy.
#include <benchmark/benchmark.h>

#include "learned/kernels/row_pairs.hpp"
#include "learned/layers/loss.hpp"
#include "learned/maps/navigation.hpp"
#include "learned/models/planner.hpp"
#include "learned/training/evaluation.hpp"

namespace praxis::learned {
namespace {

PlannerOptions network(const char* model, const char* group, int fields) {
    PlannerOptions options;
    options.model = model;
    options.group = group;
    options.fields = fields;
    return options;
}

void plan(benchmark::State& state, const PlannerOptions& options, int size) {
    const auto planner = make_planner<float>(options, 1);
    const MapSet maps = navigation_set(size, 16, 1);
    const auto trace = planner->trace(size, size);
    std::size_t k = 0;
    for (auto _ : state) {
        draw(maps.problems[k++ % maps.problems.size()], *trace);
        planner->plan(*trace);
        benchmark::DoNotOptimize(trace->policy.data());
    }
    state.SetLabel(std::to_string(planner->parameters().size()) + " parameters, " + kernels<float>().name);
}

/// One map's share of a training step: forward, loss, backward.
void learn(benchmark::State& state, const PlannerOptions& options) {
    const auto planner = make_planner<float>(options, 1);
    const MapSet maps = navigation_set(15, 16, 1);
    const auto trace = planner->trace(15, 15);
    std::vector<float> gradient(planner->parameters().size());
    std::size_t k = 0;
    for (auto _ : state) {
        const MapProblem& problem = maps.problems[k++ % maps.problems.size()];
        draw(problem, *trace);
        planner->record(*trace);
        policy_loss(Loss::all_optimal, problem, trace->policy, 1.0f, trace->of_policy);
        planner->differentiate(*trace, gradient);
        benchmark::DoNotOptimize(gradient.data());
    }
}

/// The way back alone, after 80 iterations forward.
void differentiate(benchmark::State& state, const PlannerOptions& options) {
    const auto planner = make_planner<float>(options, 1);
    const MapProblem problem = navigation_set(15, 1, 1).problems.front();
    const auto trace = planner->trace(15, 15);
    draw(problem, *trace);
    planner->record(*trace);
    policy_loss(Loss::all_optimal, problem, trace->policy, 1.0f, trace->of_policy);
    std::vector<float> gradient(planner->parameters().size());
    for (auto _ : state) {
        planner->differentiate(*trace, gradient);
        benchmark::DoNotOptimize(gradient.data());
    }
    state.counters["steps back"] =
        trace->backward_iterations ? trace->backward_iterations : trace->iterations;
}

/// The kernel that value iteration spends its time in, without its surroundings; row by row, or rows in
/// pairs.
void back_up(benchmark::State& state, int order, int fields, bool pairs) {
    const BackupShape shape{15, 15, 1, order, fields};
    Planes<float> values(order, 15, 15, 1), result = values, rewards(order * fields, 15, 15, 0);
    const std::vector<float> filter(static_cast<std::size_t>(order * order * fields * shape.taps()), 0.01f);
    std::vector<float> paired, scratch(row_pair_scratch(shape, values.stride()));
    pair_filter(order, order * fields, std::span<const float>(filter), paired);
    const auto step = [&](const Planes<float>& from, Planes<float>& to) {
        if (pairs)
            kernels<float>().backup_by_pairs(shape, from.view(), paired.data(), rewards.view(), to.view(),
                                             nullptr, scratch.data());
        else
            kernels<float>().backup(shape, from.view(), filter.data(), rewards.view(), to.view(), nullptr);
    };
    for (auto _ : state) {
        for (int k = 0; k < 15; ++k) {
            step(values, result);
            step(result, values);
        }
        benchmark::DoNotOptimize(values.data());
    }
    const double operations = 2.0 * 225 * 9 * order * order * fields * 30;
    state.counters["flop/s"] = benchmark::Counter(operations, benchmark::Counter::kIsIterationInvariantRate,
                                                  benchmark::Counter::kIs1000);
}

PlannerOptions implicit(PlannerOptions options, int iterations) {
    options.differentiation = Differentiation::implicit;
    options.iterations = iterations;
    options.tolerance = 1e-9;  // all iterations
    return options;
}

PlannerOptions deep(PlannerOptions options, int iterations) {
    options.iterations = iterations;
    return options;
}

void exact(benchmark::State& state) {
    MapSet maps = navigation_set(15, 16, 1);
    std::size_t k = 0;
    for (auto _ : state) {
        solve_exactly(maps.problems[k++ % maps.problems.size()]);
        benchmark::ClobberMemory();
    }
}

BENCHMARK_CAPTURE(back_up, VIN_10_channels_30_times, 1, 10, false);
BENCHMARK_CAPTURE(back_up, VIN_40_channels_30_times, 1, 40, false);
BENCHMARK_CAPTURE(back_up, SymVIN_8_fields_30_times, 8, 8, false);
BENCHMARK_CAPTURE(back_up, VIN_10_channels_30_times_by_pairs, 1, 10, true);
BENCHMARK_CAPTURE(back_up, SymVIN_8_fields_30_times_by_pairs, 8, 8, true);
BENCHMARK_CAPTURE(plan, VIN_10_channels, network("vin", "c1", 10), 15);
BENCHMARK_CAPTURE(plan, VIN_40_channels, network("vin", "c1", 40), 15);
BENCHMARK_CAPTURE(plan, SymVIN_8_fields, network("vin", "d4", 8), 15)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(plan, ConvGPPN_40_channels, network("gru", "c1", 40), 15)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(plan, SymGPPN_5_fields, network("gru", "d4", 5), 15)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(plan, GPPN_40_channels, network("lstm", "c1", 40), 15)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(learn, VIN_10_channels, network("vin", "c1", 10))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(learn, VIN_40_channels, network("vin", "c1", 40))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(learn, SymVIN_8_fields, network("vin", "d4", 8))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(differentiate, VIN_40_channels, deep(network("vin", "c1", 40), 80))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(differentiate, ID_VIN_40_channels, implicit(network("vin", "c1", 40), 80))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(differentiate, SymVIN_8_fields, deep(network("vin", "d4", 8), 80))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(differentiate, ID_SymVIN_8_fields, implicit(network("vin", "d4", 8), 80))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(learn, ConvGPPN_40_channels, network("gru", "c1", 40))->Unit(benchmark::kMicrosecond);
BENCHMARK(exact);

}  // namespace
}  // namespace praxis::learned
