#include "app/belief_observer.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "belief/atom_names.hpp"
#include "belief/perception/scene_observer.hpp"
#include "belief/robot_environment.hpp"
#include "belief/simulated_robot.hpp"

namespace praxis::app {
namespace {

using namespace praxis::belief;

SceneObserverSettings settings_of(const std::string& file, std::function<void(const std::string&)> warn) {
    SceneObserverSettings settings = read_scene_observer(file);
    settings.observer.warn = std::move(warn);
    return settings;
}

/// What truly holds in a world, by names.
class Truths {
  public:
    Truths(const BeliefTask& task, const SimulatedWorld& world)
        : task_(&task), world_(&world), names_(task) {}

    bool operator()(const AtomName& atom) const {
        const auto literal = names_.literal(atom);
        if (!literal) throw std::invalid_argument("the task has no atom " + to_string(atom));
        if (const auto fact = names_.fact(*literal))
            return world_->state()[index(fact->variable)] == fact->value;
        const Relation& relation = task_->source->task->initial_atoms[literal->predicate.index()];
        for (std::size_t i = 0; i < relation.count; ++i)
            if (std::ranges::equal(relation.tuple(i), literal->arguments)) return true;
        return false;
    }

  private:
    static std::string to_string(const AtomName& atom) {
        std::string text;
        for (const std::string& word : atom.words) text += (text.empty() ? "(" : " ") + word;
        return text + ")";
    }

    const BeliefTask* task_;
    const SimulatedWorld* world_;
    AtomNames names_;
};

class ObservedWorld : public Environment {
  public:
    ObservedWorld(const std::shared_ptr<const BeliefTask>& task, SimulatedWorld& world,
                  std::unique_ptr<Observer> observer)
        : robot_(task, world), observer_(std::move(observer)), environment_(task, robot_, *observer_) {}

    Execution execute(std::uint32_t action, std::stop_token stop) override {
        return environment_.execute(action, stop);
    }
    std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) override {
        try {
            return environment_.observe(action, stop);
        } catch (const PerceptionError& error) {
            throw ObserverError(error.what());
        }
    }

  private:
    SimulatedRobot robot_;
    std::unique_ptr<Observer> observer_;
    RobotEnvironment environment_;
};

}  // namespace

struct BeliefObserver::Parts {
    SceneObservers observers;
};

BeliefObserver::BeliefObserver(const std::string& file, std::function<void(const std::string&)> warn) try
    : file_(file), parts_(new Parts{SceneObservers(settings_of(file, std::move(warn)))}) {
} catch (const PerceptionError& error) {
    throw std::invalid_argument(error.what());
}

BeliefObserver::~BeliefObserver() = default;

std::unique_ptr<Environment> BeliefObserver::environment(std::shared_ptr<const BeliefTask> task,
                                                         SimulatedWorld& world) const {
    try {
        return std::make_unique<ObservedWorld>(task, world, parts_->observers.look_at(Truths(*task, world)));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(file_ + ": " + error.what());
    }
}

std::string BeliefObserver::summary() const {
    const VisionModelCounters used = parts_->observers.counters();
    char text[160];
    std::snprintf(text, sizeof text,
                  "observer: %lld requests (%lld again), %lld answers from the file, %lld + %lld tokens, "
                  "cost %g",
                  static_cast<long long>(used.requests), static_cast<long long>(used.retries),
                  static_cast<long long>(parts_->observers.replayed()),
                  static_cast<long long>(used.prompt_tokens), static_cast<long long>(used.completion_tokens),
                  used.cost);
    return text;
}

}  // namespace praxis::app
