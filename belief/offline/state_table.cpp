#include "belief/offline/state_table.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "belief/environment.hpp"

namespace praxis::belief {

bool certain_outcomes(const BeliefTask& task) {
    const auto& readings = task.readings.items();
    return task.forgotten.total() == 0 &&
           std::all_of(readings.begin(), readings.end(),
                       [](const GroundReading& reading) { return reading.accuracy >= 1; }) &&
           std::all_of(task.sensors.begin(), task.sensors.end(),
                       [](const GroundSensor& sensor) { return sensor.reading.accuracy >= 1; });
}

std::size_t StateTable::Hash::operator()(StateIndex state) const {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const std::int32_t* const values = table->values(state);
    for (std::size_t v = 0; v < table->width_; ++v)
        hash = (hash ^ static_cast<std::uint64_t>(values[v])) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

bool StateTable::Equal::operator()(StateIndex a, StateIndex b) const {
    return std::equal(table->values(a), table->values(a) + table->width_, table->values(b));
}

StateTable::StateTable(std::shared_ptr<const BeliefTask> task)
    : task_(std::move(task)),
      axioms_(*task_->physical),
      width_(task_->physical->variable_count()),
      index_(16, Hash{this}, Equal{this}) {}

StateIndex StateTable::add(const WorldState& state) {
    next_ = state;
    return intern(next_);
}

StateIndex StateTable::successor(StateIndex state, std::uint32_t action) {
    const FiniteDomainTask& task = *task_->physical;
    const std::int32_t* const before = values(state);
    next_.assign(before, before + width_);
    for (const GroundEffect& effect : task.effects[action])
        if (all_hold(task.conditions[effect.condition], before))
            next_[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    return intern(next_);
}

StateIndex StateTable::intern(const std::vector<std::int32_t>& values) {
    const FiniteDomainTask& task = *task_->physical;
    const auto number = static_cast<StateIndex>(size());
    const std::size_t first = values_.size();
    values_.insert(values_.end(), values.begin(), values.end());
    if (!axioms_.trivial()) {
        for (std::size_t v = 0; v < width_; ++v)
            if (task.derived(static_cast<std::int32_t>(v))) values_[first + v] = task.initial_values[v];
        axioms_.complete(values_.data() + first, scratch_);
    }
    const auto [found, fresh] = index_.insert(number);
    if (!fresh) values_.resize(first);
    return *found;
}

std::vector<Fact> StateTable::observation(StateIndex state, std::uint32_t action) const {
    std::vector<Fact> answers;
    if (action != Environment::kStart)
        for (const GroundReading& reading : task_->readings[action]) answer(state, reading.fact, answers);
    for (std::size_t s = 0; s < task_->sensors.size(); ++s)
        if (all_hold(task_->sensor_conditions[s], values(state)))
            answer(state, task_->sensors[s].reading.fact, answers);
    std::sort(answers.begin(), answers.end());
    answers.erase(std::unique(answers.begin(), answers.end()), answers.end());
    return answers;
}

void StateTable::answer(StateIndex state, Fact fact, std::vector<Fact>& answers) const {
    const std::int32_t value = values(state)[fact.variable];
    // "No" about one of more than two values names no fact.
    if (value == fact.value || task_->physical->domain_sizes[static_cast<std::size_t>(fact.variable)] == 2)
        answers.push_back({fact.variable, value});
}

std::vector<Answered> split_by_observation(const StateTable& table, std::span<const StateIndex> states,
                                           std::uint32_t action) {
    std::map<std::vector<Fact>, std::vector<StateIndex>> parts;
    for (StateIndex state : states) parts[table.observation(state, action)].push_back(state);
    std::vector<Answered> result;
    for (auto& [observation, part] : parts) result.push_back({observation, std::move(part)});
    return result;
}

}  // namespace praxis::belief
