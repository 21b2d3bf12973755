// What a cycle of practice costs the competence models.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "practice/competence/competences.hpp"
#include "practice/competence/latent_model.hpp"
#include "practice/competence/shared_prior.hpp"
#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

/// `advance_cycle` of a latent model at the end of its n-th cycle of 1..20 outcomes: its curve is fitted
/// anew.
void latent_cycle(benchmark::State& state) {
    Random random(3);
    LatentModel model({10, 1}, 0.5);
    for (std::int64_t cycle = 1; cycle <= state.range(0); ++cycle) {
        if (cycle > 1) model.advance_cycle();
        const double competence =
            0.2 + 0.6 * static_cast<double>(cycle) / static_cast<double>(state.range(0));
        for (std::size_t n = 1 + random.below(20); n > 0; --n) model.observe(uniform(random) < competence);
    }
    for (auto _ : state) {
        LatentModel copy = model;
        copy.advance_cycle();
        benchmark::DoNotOptimize(copy.competence());
    }
}
BENCHMARK(latent_cycle)->Arg(5)->Arg(20)->Arg(100)->Unit(benchmark::kMicrosecond);

void shared_prior_of(benchmark::State& state) {
    Random random(5);
    std::vector<Counts> siblings(static_cast<std::size_t>(state.range(0)));
    for (Counts& counts : siblings)
        for (std::size_t n = 1 + random.below(40); n > 0; --n) counts.add(uniform(random) < 0.6);
    for (auto _ : state) benchmark::DoNotOptimize(shared_prior(siblings, {10, 1}));
}
BENCHMARK(shared_prior_of)->Arg(5)->Arg(20)->Arg(100)->Unit(benchmark::kMicrosecond);

/// Making the competences of n skills of ten schemas, of which twenty are then tried for a cycle.
void competences_of(benchmark::State& state) {
    std::vector<std::int32_t> schemas(static_cast<std::size_t>(state.range(0)));
    for (std::size_t i = 0; i < schemas.size(); ++i) schemas[i] = static_cast<std::int32_t>(i % 10);
    for (auto _ : state) {
        Competences competences(schemas, {}, true);
        for (std::size_t i = 0; i < 200; ++i) competences.observe(i % 20, i % 3 == 0);
        competences.advance_cycle();
        benchmark::DoNotOptimize(competences.competence(schemas.size() - 1));
    }
}
BENCHMARK(competences_of)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace praxis::practice
