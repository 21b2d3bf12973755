// The machinery of search: states a second of blind A*, applicable operators a second, and the time to
// prepare a task.
//
//     search_bench [Google Benchmark options]
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "search/engines/search.hpp"
#include "search/state/successor_generator.hpp"

namespace {

using namespace praxis;

/// A task under construction: variables first, then operators.
class TaskBuilder {
  public:
    TaskBuilder() {
        task_.conditions.close();
        task_.first_fact = {0};
    }
    std::int32_t variable(std::int32_t domain_size) {
        task_.domain_sizes.push_back(domain_size);
        task_.axiom_layers.push_back(-1);
        task_.initial_values.push_back(0);
        task_.first_fact.push_back(task_.first_fact.back() + static_cast<std::uint32_t>(domain_size));
        return static_cast<std::int32_t>(task_.variable_count()) - 1;
    }
    void add(const std::vector<Fact>& precondition, const std::vector<Fact>& effects) {
        task_.preconditions.append(precondition);
        for (Fact fact : effects) task_.effects.add({fact, 0});
        task_.effects.close();
        task_.costs.push_back(1);
    }
    FiniteDomainTask finish(std::vector<Fact> goal) {
        task_.goal = std::move(goal);
        return std::move(task_);
    }

  private:
    FiniteDomainTask task_;
};

/// A robot with two grippers carries balls from room 0 to room 1.
FiniteDomainTask gripper_task(std::int32_t balls) {
    TaskBuilder builder;
    const std::int32_t robot = builder.variable(2);
    const std::int32_t grippers[] = {builder.variable(2), builder.variable(2)};
    builder.add({{robot, 0}}, {{robot, 1}});
    builder.add({{robot, 1}}, {{robot, 0}});
    std::vector<Fact> goal;
    for (std::int32_t i = 0; i < balls; ++i) {
        const std::int32_t ball = builder.variable(4);  // in room 0, in room 1, in gripper 0, in gripper 1
        for (std::int32_t side = 0; side < 2; ++side) {
            for (std::int32_t room = 0; room < 2; ++room) {
                builder.add({{robot, room}, {grippers[side], 0}, {ball, room}},
                            {{grippers[side], 1}, {ball, 2 + side}});
                builder.add({{robot, room}, {ball, 2 + side}}, {{grippers[side], 0}, {ball, room}});
            }
        }
        goal.push_back({ball, 1});
    }
    return builder.finish(std::move(goal));
}

/// `operators` operators with three random preconditions each over 50 variables of 40 values.
FiniteDomainTask wide_task(int operators) {
    TaskBuilder builder;
    for (int i = 0; i < 50; ++i) builder.variable(40);
    std::mt19937 random(1);
    const auto below = [&](int bound) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(bound));
    };
    for (int i = 0; i < operators; ++i) {
        const std::int32_t first = below(48), second = first + 1 + below(48 - first), third = second + 1;
        builder.add({{first, below(40)}, {second, below(40)}, {third, below(40)}}, {{first, below(40)}});
    }
    return builder.finish({{0, 1}});
}

void run_search(benchmark::State& state, const char* expression) {
    const PreparedTask prepared(
        std::make_shared<FiniteDomainTask>(gripper_task(static_cast<std::int32_t>(state.range(0)))));
    const Query query = task_query(prepared.task());
    const Configuration config = configuration(expression);
    std::uint64_t states = 0, generated = 0;
    double bytes = 0;
    for (auto _ : state) {
        const Outcome outcome = search(prepared, query, config);
        states += outcome.statistics.registered_states;
        generated += outcome.statistics.generated;
        bytes = outcome.statistics.bytes_per_state;
    }
    state.counters["states/s"] = benchmark::Counter(static_cast<double>(states), benchmark::Counter::kIsRate);
    state.counters["generated/s"] =
        benchmark::Counter(static_cast<double>(generated), benchmark::Counter::kIsRate);
    state.counters["bytes/state"] = bytes;
}

void blind_astar(benchmark::State& state) {
    run_search(state, "astar(blind())");
}
BENCHMARK(blind_astar)->Arg(6)->Arg(9)->Arg(12)->Unit(benchmark::kMillisecond);

void lazy_goal_count(benchmark::State& state) {
    run_search(state, "lazy_greedy([goalcount()])");
}
BENCHMARK(lazy_goal_count)->Arg(9)->Unit(benchmark::kMillisecond);

void applicable_operators(benchmark::State& state) {
    const FiniteDomainTask task = wide_task(static_cast<int>(state.range(0)));
    const SuccessorGenerator generator(task);
    std::mt19937 random(2);
    std::vector<std::int32_t> values(task.variable_count());
    std::vector<OperatorId> operators;
    std::size_t found = 0;
    for (auto _ : state) {
        for (std::int32_t& value : values) value = static_cast<std::int32_t>(random() % 40);
        generator.applicable(values.data(), operators);
        found += operators.size();
    }
    state.counters["operators/s"] =
        benchmark::Counter(static_cast<double>(found), benchmark::Counter::kIsRate);
    state.counters["bytes/operator"] =
        static_cast<double>(generator.memory()) / static_cast<double>(state.range(0));
}
BENCHMARK(applicable_operators)->Arg(1000)->Arg(1000000);

void prepare_task(benchmark::State& state) {
    const auto task = std::make_shared<FiniteDomainTask>(wide_task(static_cast<int>(state.range(0))));
    for (auto _ : state) benchmark::DoNotOptimize(PreparedTask(task));
}
BENCHMARK(prepare_task)->Arg(1000)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
