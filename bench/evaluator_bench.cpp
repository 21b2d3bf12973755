// Evaluations a second: every evaluator on states of random walks from the initial state.
//
//     evaluator_bench [Google Benchmark options] FILE.sas...       (without files: a transport task made
//     here)
//
// `plan ground DOMAIN PROBLEM --sas FILE` writes such files, and so does Fast Downward's translator.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <sstream>

#include "parser/diagnostic.hpp"
#include "search/evaluators/blind.hpp"
#include "search/evaluators/ff.hpp"
#include "search/evaluators/goal_count.hpp"
#include "search/evaluators/hadd.hpp"
#include "search/evaluators/hmax.hpp"
#include "search/evaluators/lmcut.hpp"
#include "search/state/axiom_evaluator.hpp"
#include "search/state/successor_generator.hpp"
#include "search/task/sas.hpp"

namespace {

using namespace praxis;

/// Packages 0, 1, ... to be carried by trucks along a ring of places.
FiniteDomainTask transport_task(std::int32_t trucks, std::int32_t packages, std::int32_t places) {
    FiniteDomainTask task;
    task.conditions.close();
    task.first_fact = {0};
    for (std::int32_t v = 0; v < trucks + packages; ++v) {
        const std::int32_t size = v < trucks ? places : places + trucks;
        task.domain_sizes.push_back(size);
        task.axiom_layers.push_back(-1);
        task.initial_values.push_back((v * 7) % places);
        task.first_fact.push_back(task.first_fact.back() + static_cast<std::uint32_t>(size));
    }
    const auto add = [&task](std::vector<Fact> preconditions, Fact effect) {
        task.preconditions.append(preconditions);
        task.effects.append(std::vector<GroundEffect>{{effect, 0}});
        task.costs.push_back(1);
    };
    for (std::int32_t truck = 0; truck < trucks; ++truck) {
        for (std::int32_t place = 0; place < places; ++place) {
            add({{truck, place}}, {truck, (place + 1) % places});
            add({{truck, place}}, {truck, (place + places - 1) % places});
            for (std::int32_t package = trucks; package < trucks + packages; ++package) {
                add({{truck, place}, {package, place}}, {package, places + truck});
                add({{truck, place}, {package, places + truck}}, {package, place});
            }
        }
    }
    for (std::int32_t v = trucks; v < trucks + packages; ++v) task.goal.push_back({v, (v * 13 + 5) % places});
    return task;
}

/// States of walks of fifty random steps each.
std::vector<std::vector<std::int32_t>> walk(const FiniteDomainTask& task, std::size_t count) {
    const SuccessorGenerator generator(task);
    const AxiomEvaluator axioms(task);
    AxiomEvaluator::Scratch scratch;
    std::mt19937 random(1);
    std::vector<std::vector<std::int32_t>> states;
    std::vector<OperatorId> operators;
    for (std::vector<std::int32_t> state; states.size() < count;) {
        operators.clear();
        if (states.size() % 50 != 0) generator.applicable(state.data(), operators);
        if (operators.empty()) {
            state = task.initial_values;
        } else {
            const std::vector<std::int32_t> before = state;
            const std::size_t op = operators[random() % operators.size()].index();
            for (const GroundEffect& effect : task.effects[op]) {
                bool fires = true;
                for (const Fact fact : task.conditions[effect.condition]) {
                    fires = fires && before[static_cast<std::size_t>(fact.variable)] == fact.value;
                }
                if (fires) state[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
            }
        }
        axioms.complete(state.data(), scratch);
        states.push_back(state);
    }
    return states;
}

template <class E>
void add_benchmark(const std::string& name, std::shared_ptr<const FiniteDomainTask> task) {
    benchmark::RegisterBenchmark((name + "/construct").c_str(), [task](benchmark::State& run) {
        for (auto _ : run) {
            E evaluator(*task, task->goal, CostType::normal);
            benchmark::DoNotOptimize(&evaluator);
        }
    });
    benchmark::RegisterBenchmark((name + "/evaluate").c_str(), [task](benchmark::State& run) {
        const auto states = walk(*task, 1000);
        E evaluator(*task, task->goal, CostType::normal);
        evaluator.request_preferred();
        std::size_t next = 0;
        for (auto _ : run) {
            benchmark::DoNotOptimize(evaluator.evaluate(states[next]));
            next = (next + 1) % states.size();
        }
        run.SetItemsProcessed(run.iterations());
    });
}

void add_benchmarks(const std::string& name, std::shared_ptr<const FiniteDomainTask> task) {
    add_benchmark<BlindEvaluator>(name + "/blind", task);
    add_benchmark<GoalCountEvaluator>(name + "/goalcount", task);
    add_benchmark<HmaxEvaluator>(name + "/hmax", task);
    add_benchmark<AddEvaluator>(name + "/add", task);
    add_benchmark<FFEvaluator>(name + "/ff", task);
    add_benchmark<LMCutEvaluator>(name + "/lmcut", task);
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    if (argc == 1) {
        add_benchmarks("transport", std::make_shared<const FiniteDomainTask>(transport_task(6, 20, 40)));
    }
    for (int i = 1; i < argc; ++i) {
        std::ifstream file(argv[i], std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        const std::string name(argv[i]);
        add_benchmarks(name.substr(name.rfind('/') + 1),
                       std::make_shared<const FiniteDomainTask>(read_sas({name, text.str()})));
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
} catch (const InputError& error) {
    std::cerr << error.what();
    return 31;
}
