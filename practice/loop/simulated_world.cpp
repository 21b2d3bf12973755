#include "practice/loop/simulated_world.hpp"

#include <utility>

namespace praxis::practice {

namespace {

constexpr std::uint64_t kSkill = 1, kTask = 2;

}  // namespace

Random random_stream(std::uint64_t seed, std::uint64_t purpose, std::uint64_t number) {
    const std::uint64_t mixed = Random(seed).next() ^ purpose;
    return Random(Random(mixed).next() ^ number);
}

std::vector<GroundAtom> SimulatedWorld::next_task() {
    Random random = random_stream(seed_, kTask, tasks_++);
    PracticeTask task = environment_->sample_task(random);
    if (reset_ || tasks_ == 1) state_ = std::move(task.initial);
    return std::move(task.goal);
}

void SimulatedWorld::execute(const GroundSkill& skill, std::span<const double> parameters) {
    Random random = random_stream(seed_, kSkill, skills_++);
    environment_->execute(state_, skill, parameters, random);
}

void SimulatedWorld::resume(const State& state, std::uint64_t skills, std::uint64_t tasks) {
    state_ = state;
    skills_ = skills;
    tasks_ = tasks;
}

}  // namespace praxis::practice
