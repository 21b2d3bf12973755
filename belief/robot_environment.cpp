#include "belief/robot_environment.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {

RobotEnvironment::RobotEnvironment(std::shared_ptr<const BeliefTask> task, Skills& skills, Observer& observer,
                                   std::optional<Percept> pending)
    : task_(std::move(task)),
      skills_(&skills),
      observer_(&observer),
      names_(*task_),
      pending_(std::move(pending)) {
    const LiftedTask& lifted = *task_->source->task;
    std::vector<bool> hidden(lifted.objects.size(), false);
    for (ObjectId object : task_->source->hidden_objects) hidden[object.index()] = true;
    for (std::size_t o = 0; o < hidden.size(); ++o)
        if (!hidden[o]) objects_.push_back(lifted.objects[o].name);
    for (const GroundSensor& sensor : task_->sensors)
        sensed_.push_back(AtomNames::name(*task_->physical, sensor.reading.fact));
    read_.resize(task_->operator_count());
    for (std::size_t a = 0; a < read_.size(); ++a)
        for (const GroundReading& reading : task_->readings[a])
            read_[a].push_back(AtomNames::name(*task_->physical, reading.fact));
}

Execution RobotEnvironment::execute(std::uint32_t action, std::stop_token stop) {
    Execution execution = skills_->execute(AtomNames::name(*task_->physical, action), {}, stop);
    failed_ = execution.status == Execution::Status::failed;
    return execution;
}

/// The atoms that the action changes, whatever they become.
void RobotEnvironment::ask_for_effects(std::uint32_t action, std::vector<AtomName>& questions) const {
    const FiniteDomainTask& physical = *task_->physical;
    std::vector<std::int32_t> variables(task_->forgotten[action].begin(), task_->forgotten[action].end());
    for (const GroundEffect& effect : physical.effects[action]) variables.push_back(effect.fact.variable);
    for (const Fact& fact : physical.preconditions[action]) {
        const bool changed = std::find(variables.begin(), variables.end(), fact.variable) != variables.end();
        if (changed && physical.is_atom(fact)) questions.push_back(AtomNames::name(physical, fact));
    }
    for (const GroundEffect& effect : physical.effects[action])
        if (names_.literal(effect.fact)) questions.push_back(AtomNames::name(physical, effect.fact));
    for (std::int32_t variable : task_->forgotten[action])
        questions.push_back(AtomNames::name(physical, {variable, 0}));
}

std::vector<Answer> RobotEnvironment::observe(std::uint32_t action, std::stop_token stop) {
    std::vector<AtomName> questions = sensed_;
    ActionName name;
    if (action != kStart) {
        name = AtomNames::name(*task_->physical, action);
        questions.insert(questions.end(), read_[action].begin(), read_[action].end());
        if (failed_) ask_for_effects(action, questions);
    }
    std::sort(questions.begin(), questions.end());
    questions.erase(std::unique(questions.begin(), questions.end()), questions.end());
    const ObservationRequest request{action == kStart ? nullptr : &name, questions, objects_};
    percept_ = action == kStart && pending_ ? *pending_ : observer_->observe(request, stop);

    std::vector<Answer> answers;
    for (const Reading& reading : percept_.readings) {
        if (reading.value == Truth::unknown) continue;
        const bool holds = reading.value == Truth::known_true;
        if (const auto fact = names_.fact(reading.atom)) {
            const bool two = task_->physical->domain_sizes[static_cast<std::size_t>(fact->variable)] == 2;
            if (holds || two)
                answers.push_back({holds ? *fact : Fact{fact->variable, 1 - fact->value}, reading.accuracy});
        } else if (holds) {
            for (std::size_t i = 1; i < reading.atom.words.size(); ++i)
                note_new({reading.atom.words[i], "", {}, 1});
        }
    }
    for (const Detection& detection : percept_.detections) note_new(detection);
    return answers;
}

void RobotEnvironment::note_new(const Detection& detection) {
    const auto is = [&](const std::string& name) { return name == detection.object; };
    if (std::any_of(objects_.begin(), objects_.end(), is)) return;
    for (const Detection& other : found_)
        if (is(other.object)) return;
    found_.push_back(detection);
}

}  // namespace praxis::belief
