#include "practice/loop/practice_loop.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace praxis::practice {

namespace {

void check(const PracticeOptions& options) {
    if (options.cycles < 0 || options.cycle_steps < 0 || options.learn_every < 0 || options.score_every < 1 ||
        options.test_tasks < 0 || options.test_every < 0 || options.situations < 1 || options.replans < 0 ||
        !(options.bonus >= 0) || std::isinf(options.bonus))
        throw std::invalid_argument(
            "cycles, steps, tasks and the bonus must be finite and not negative, and there must be one "
            "situation at least");
    if (options.candidates != "tried" && options.candidates != "all")
        throw std::invalid_argument("candidates are 'tried' or 'all', not '" + options.candidates + "'");
}

}  // namespace

PracticeLoop::PracticeLoop(const Environment& environment, World& world, const PracticeOptions& options)
    : world_(&world), learner_((check(options), environment), options) {
    if (cycle_steps() < 1)
        throw std::invalid_argument(
            "the environment does not say how many skills a cycle takes; give cycle_steps");
    method_ = make_method(options.method, learner_);
}

int PracticeLoop::cycle_steps() const {
    const int steps = learner_.options().cycle_steps;
    return steps > 0 ? steps : learner_.skills().environment().description().cycle_steps;
}

void PracticeLoop::step(const Decision& decision, const std::function<void()>& on_learned) {
    world_->execute(learner_.skills().skill(decision.skill), decision.parameters);
    Moment after = learner_.moment(world_->observe());
    const bool success = learner_.observe(now_, decision, after);
    method_->observe(now_, decision, after, success, false);
    now_ = std::move(after);
    const int interval = learner_.options().learn_every;
    if (interval > 0 && learner_.transitions() - learned_ >= interval) learn(on_learned);
}

void PracticeLoop::learn(const std::function<void()>& on_learned) {
    learned_ = learner_.transitions();
    learner_.learn();
    method_->learned();
    if (on_learned) on_learned();
}

bool PracticeLoop::run_cycle(std::stop_token stop, const std::function<void()>& on_learned) {
    const SkillTask& skills = learner_.skills();
    const std::vector<Fact> goal = skills.goal(world_->next_task());
    now_ = learner_.moment(world_->observe());
    method_->begin_task({now_.values, goal}, false);
    const std::int64_t begin = learner_.transitions();
    const std::int64_t end = begin + cycle_steps();
    const auto more = [&] { return learner_.transitions() < end && !stop.stop_requested(); };
    for (int i = 0; i < skills.environment().description().horizon && more(); ++i) {
        if (all_hold(goal, now_.values.data())) break;
        const std::optional<Decision> decision = method_->pursue(now_, goal, learner_.random(), false);
        if (!decision) break;
        step(*decision, on_learned);
    }
    method_->begin_practice();
    while (more()) {
        const std::optional<Decision> decision = method_->practise(now_);
        if (!decision) break;
        step(*decision, on_learned);
    }
    if (stop.stop_requested() || learner_.transitions() == begin) return false;
    if (learned_ < learner_.transitions()) learn(on_learned);
    method_->end_cycle();
    return true;
}

bool PracticeLoop::solves(const SimulatedEnvironment& environment, const PracticeTask& task, Random& random) {
    const SkillTask& skills = learner_.skills();
    const std::vector<Fact> goal = skills.goal(task.goal);
    Moment now = learner_.moment(task.initial);
    method_->begin_task({now.values, goal}, true);
    for (int i = 0; i < environment.description().horizon; ++i) {
        if (all_hold(goal, now.values.data())) return true;
        const std::optional<Decision> decision = method_->pursue(now, goal, random, true);
        if (!decision) return false;
        Moment after{now.state, {}};
        environment.execute(after.state, skills.skill(decision->skill), decision->parameters, random);
        skills.read(after.state, after.values);
        const bool success = skills.succeeded(decision->skill, now.values, after.values);
        method_->observe(now, *decision, after, success, true);
        now = std::move(after);
    }
    return all_hold(goal, now.values.data());
}

}  // namespace praxis::practice
