#include "belief/explore.hpp"

#include <algorithm>
#include <utility>

#include "belief/grow.hpp"
#include "belief/robot_environment.hpp"

namespace praxis::belief {

Exploration explore(std::shared_ptr<const ContingentTask> full, Skills& skills, Observer& observer,
                    const AgentOptions& options, const Budget& budget,
                    const std::function<void(const Event&, const Belief&)>& watch,
                    const CompilationOptions& compilation_options) {
    const auto tell = [&](Event::Kind kind, const std::string& text, const Belief& belief) {
        if (!watch) return;
        Event event;
        event.kind = kind;
        event.text = text;
        watch(event, belief);
    };
    Exploration result;
    Percept pending;
    AgentOptions left = options;
    for (;;) {
        result.task = full;
        const GroundBeliefResult ground = ground_belief(visible_part(*full), budget);
        if (!ground.task) {
            result.status = ground.stop == Stop::memory ? RunStatus::out_of_memory : RunStatus::out_of_time;
            return result;
        }
        ++result.groundings;
        const auto compilation = std::make_shared<const Compilation>(ground.task, compilation_options);
        const auto planner = std::make_shared<const KnowledgePlanner>(compilation, budget);
        Belief belief(compilation);
        RobotEnvironment environment(ground.task, skills, observer,
                                     result.groundings > 1 ? std::optional(pending) : std::nullopt);
        const RunResult run = Agent(planner, left).run(belief, environment, budget, watch);
        for (std::uint32_t action : run.actions)
            result.actions.push_back(AtomNames::name(*ground.task->physical, action));
        result.plan_seconds.insert(result.plan_seconds.end(), run.plan_seconds.begin(),
                                   run.plan_seconds.end());
        result.status = run.status;
        result.message = run.message;
        if (run.status != RunStatus::found_objects) return result;
        left.most_steps = options.most_steps - std::min(options.most_steps, result.actions.size());
        std::vector<std::string> refused;
        full = grow(*full, belief, environment.found(), refused);
        for (const Detection& detection : environment.found()) {
            tell(Event::Kind::found, detection.object, belief);
            if (std::find(refused.begin(), refused.end(), detection.object) != refused.end()) {
                result.message = "the type '" + detection.type + "' of '" + detection.object +
                                 "', which was found, is not one of the domain";
                tell(Event::Kind::finished, result.message, belief);
                return result;
            }
            result.found.push_back(detection.object);
        }
        pending = environment.percept();
    }
}

}  // namespace praxis::belief
