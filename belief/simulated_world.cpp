#include "belief/simulated_world.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace praxis::belief {

namespace {

bool chance(Random& random, double probability) {
    return probability > 0 && static_cast<double>(random.next() >> 11) * 0x1p-53 < probability;
}

}  // namespace

SimulatedWorld::SimulatedWorld(std::shared_ptr<const BeliefTask> task, WorldState state, double noise,
                               std::uint64_t seed, double failures)
    : task_(std::move(task)),
      axioms_(*task_->physical),
      state_(std::move(state)),
      noise_(noise),
      failures_(failures),
      random_(seed) {
    if (!(noise >= 0 && noise <= 0.5)) throw std::invalid_argument("noise must be between 0 and 0.5");
    if (!(failures >= 0 && failures <= 1))
        throw std::invalid_argument("the probability of failures must be between 0 and 1");
    complete();
}

Execution SimulatedWorld::execute(std::uint32_t action, std::stop_token) {
    if (!applicable(action)) {
        return {Execution::Status::illegal,
                task_->physical->operator_name(OperatorId(action)) + " is not possible here"};
    }
    reads_ = !chance(random_, failures_);
    if (reads_ || chance(random_, 0.5)) apply(action);
    if (reads_) return {};
    ++failed_;
    return {Execution::Status::failed, ""};
}

void SimulatedWorld::apply(std::uint32_t action) {
    const FiniteDomainTask& task = *task_->physical;
    before_ = state_;
    for (const GroundEffect& effect : task.effects[action])
        if (all_hold(task.conditions[effect.condition], before_.data()))
            state_[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    forget(action);
    complete();
    happened_.push_back(action);
    if (!task_->forgotten[action].empty()) after_chance_.push_back(state_);
}

void SimulatedWorld::forget(std::uint32_t action) {
    const auto forgotten = task_->forgotten[action];
    if (forgotten.empty()) return;
    for (std::int32_t variable : forgotten)
        state_[static_cast<std::size_t>(variable)] = static_cast<std::int32_t>(random_.below(2));
    for (std::size_t c = 0; c < task_->choices.size(); ++c) {
        const auto choice = task_->choices[c];
        if (std::find(forgotten.begin(), forgotten.end(), choice.front().variable) == forgotten.end())
            continue;
        for (const Fact& fact : choice) state_[static_cast<std::size_t>(fact.variable)] = 1 - fact.value;
        const Fact& chosen = choice[random_.below(choice.size())];
        state_[static_cast<std::size_t>(chosen.variable)] = chosen.value;
    }
    for (const GroundDefinition& definition : task_->definitions) definition.settle(state_.data());
}

std::vector<Answer> SimulatedWorld::observe(std::uint32_t action, std::stop_token) {
    std::vector<Answer> answers;
    if (action != kStart && reads_)
        for (const GroundReading& reading : task_->readings[action]) answer(reading, answers);
    for (std::size_t s = 0; s < task_->sensors.size(); ++s)
        if (all_hold(task_->sensor_conditions[s], state_.data())) answer(task_->sensors[s].reading, answers);
    return answers;
}

void SimulatedWorld::answer(const GroundReading& reading, std::vector<Answer>& answers) {
    const double error = noise_ + (1 - reading.accuracy) * (1 - 2 * noise_);
    Answer answer{reading.fact, 1 - error};
    bool holds = state_[static_cast<std::size_t>(reading.fact.variable)] == reading.fact.value;
    if (chance(random_, error)) holds = !holds;
    if (!holds) {
        // Facts that are read are one of two values, or certain anyway.
        const auto variable = static_cast<std::size_t>(reading.fact.variable);
        if (task_->physical->domain_sizes[variable] != 2) return;
        answer.fact.value = 1 - reading.fact.value;
    }
    answers.push_back(answer);
}

void SimulatedWorld::complete() {
    const FiniteDomainTask& task = *task_->physical;
    for (std::size_t v = 0; v < state_.size(); ++v)
        if (task.derived(static_cast<std::int32_t>(v))) state_[v] = task.initial_values[v];
    axioms_.complete(state_.data(), scratch_);
}

}  // namespace praxis::belief
