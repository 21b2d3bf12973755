// Situating: what the plans of 20 tasks would cost if one of 100 skills were better, the inner question of
// choosing what to practise. Cold: the first question of a run, which expands the states; warm: each later
// one, for which every skill's cost has changed.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "practice/environments/environments.hpp"
#include "practice/planning/cost_planner.hpp"

namespace praxis::practice {
namespace {

constexpr std::size_t kTasks = 20, kCandidates = 100;

struct Questions {
    explicit Questions(const std::string& name) : environment(make_environment(name)), skills(*environment) {
        Random random(1);
        for (int draws = 0; situations.size() < kTasks && draws < 1000; ++draws) {
            const PracticeTask task = environment->sample_task(random);
            Situation situation{{}, skills.goal(task.goal)};
            skills.read(task.initial, situation.values);
            if (std::ranges::find(situations, situation) == situations.end())
                situations.push_back(std::move(situation));
        }
        for (std::size_t i = 0; i < kCandidates; ++i)
            candidates.push_back(static_cast<SkillIndex>(i * skills.size() / kCandidates % skills.size()));
        renew(random);
    }

    /// Other competences of all skills; the candidates are expected to improve.
    void renew(Random& random) {
        costs.clear();
        improvements.clear();
        std::vector<double> competences;
        for (std::size_t i = 0; i < skills.size(); ++i) competences.push_back(uniform(random, 0.05, 1));
        for (const double competence : competences) costs.push_back(success_cost(competence));
        for (const SkillIndex skill : candidates)
            improvements.push_back({skill, success_cost(std::min(1.0, competences[skill] + 0.1))});
    }

    std::unique_ptr<SimulatedEnvironment> environment;
    SkillTask skills;
    std::vector<Situation> situations;
    std::vector<SkillIndex> candidates;
    std::vector<Cost> costs;
    std::vector<Improvement> improvements;
};

CostPlannerOptions with_threads(const benchmark::State& state) {
    CostPlannerOptions options;
    options.threads = static_cast<int>(state.range(0));
    return options;
}

void report(benchmark::State& state, const Questions& questions, const CostPlanner& planner) {
    state.counters["states"] = static_cast<double>(planner.states());
    state.counters["skills"] = static_cast<double>(questions.skills.size());
    state.counters["tasks"] = static_cast<double>(questions.situations.size());
}

void cold(benchmark::State& state, const std::string& name) {
    const Questions questions(name);
    for (auto _ : state) {
        CostPlanner planner(questions.skills, with_threads(state));
        benchmark::DoNotOptimize(
            planner.expected_costs(questions.situations, questions.costs, questions.improvements));
        report(state, questions, planner);
    }
}

void warm(benchmark::State& state, const std::string& name) {
    Questions questions(name);
    CostPlanner planner(questions.skills, with_threads(state));
    planner.expected_costs(questions.situations, questions.costs, questions.improvements);
    Random random(2);
    for (auto _ : state) {
        state.PauseTiming();
        questions.renew(random);
        state.ResumeTiming();
        benchmark::DoNotOptimize(
            planner.expected_costs(questions.situations, questions.costs, questions.improvements));
    }
    report(state, questions, planner);
}

void threads(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK_CAPTURE(cold, playroom, "playroom")->Apply(threads);
BENCHMARK_CAPTURE(cold, kitchen, "kitchen")->Apply(threads);
BENCHMARK_CAPTURE(cold, ball_ring, "ball-ring")->Apply(threads);
BENCHMARK_CAPTURE(warm, playroom, "playroom")->Apply(threads);
BENCHMARK_CAPTURE(warm, kitchen, "kitchen")->Apply(threads);
BENCHMARK_CAPTURE(warm, ball_ring, "ball-ring")->Apply(threads);

}  // namespace
}  // namespace praxis::practice
