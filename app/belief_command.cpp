#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/belief_exploration.hpp"
#include "app/belief_observer.hpp"
#include "app/belief_offline.hpp"
#include "app/belief_runs.hpp"
#include "app/belief_table.hpp"
#include "app/belief_teller.hpp"
#include "app/belief_worlds.hpp"
#include "app/belief_yardstick.hpp"
#include "app/commands.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "belief/policies/prepared_policy.hpp"
#include "belief/policies/run_policy.hpp"
#include "belief/simulated_world.hpp"
#include "belief/view/run_page.hpp"

namespace praxis::app {
namespace {

using namespace praxis::belief;

/// In the task's units; an action that the world refused counts one.
double length(const BeliefTask& task, const PolicyResult& result) {
    const FiniteDomainTask& physical = *task.physical;
    if (physical.unit_cost) return static_cast<double>(result.steps);
    double cost = static_cast<double>(result.steps - result.run.actions.size());
    for (const std::uint32_t action : result.run.actions)
        cost += static_cast<double>(physical.costs[action]) / static_cast<double>(physical.cost_scale);
    return cost;
}

/// Acts in one world after the other.
class Runner {
  public:
    Runner(Run& run, const BeliefOptions& options, std::shared_ptr<const KnowledgePlanner> planner)
        : run_(run),
          options_(options),
          task_(planner->compilation().shared_belief()),
          worlds_(*task_, options),
          teller_(worlds_.count() == 1, !options.trace.empty()) {
        context_.options = belief_agent_options(options, planner->compilation().task()->axioms.size());
        context_.planner = std::move(planner);
        if (!options.view.empty() && worlds_.count() != 1)
            throw std::invalid_argument("--view shows one run, and there are " +
                                        std::to_string(worlds_.count()) + "; add --" +
                                        (options.samples ? "seeds" : "runs") + " 1");
    }

    Ending operator()() {
        if (!options_.observer.empty())
            observer_ = std::make_unique<BeliefObserver>(
                options_.observer, [this](const std::string& text) { run_.say("observer: " + text); });
        if (options_.optimum) measure_world();
        // Weighing readings and following a plan for right ones do not go together.
        if (options_.policy == "best" && options_.noise == 0 && options_.observer.empty() &&
            options_.search.empty())
            context_.prepared = prepare_best(task_, run_.budget());
        run_.set_phase("acting");
        for (std::size_t i = 0; i < worlds_.count(); ++i) {
            if (run_.budget().exhausted() != Stop::none && !runs_.empty()) break;
            act(i, worlds_.next(i));
            if (!runs_.back().error.empty()) break;
        }
        if (observer_) run_.say(observer_->summary());
        const bool single = worlds_.count() == 1;
        std::string text = single ? teller_.text() : belief_table(runs_, options_.optimum);
        if (single && options_.optimum) text += belief_comparison(runs_[0]);
        if (options_.trace != "-" && options_.view != "-") run_.set_result(std::move(text));
        if (!options_.trace.empty()) write_file(options_.trace, teller_.trace());
        if (!options_.view.empty()) write_file(options_.view, page_);
        return belief_ending(run_, runs_, worlds_.count());
    }

  private:
    void measure_world() {
        run_.set_phase("computing the best policy");
        yardstick_ = std::make_unique<BeliefYardstick>(task_, run_.budget());
        if (!yardstick_->message().empty())
            run_.say("the best policy is not known: " + yardstick_->message());
    }

    void act(std::size_t number, const WorldState& first) {
        const double start = processor_seconds();
        context_.seed = options_.seed + number;
        Belief belief(context_.planner->shared_compilation());
        SimulatedWorld world(task_, first, options_.noise, options_.seed + number, options_.failures);
        std::unique_ptr<Environment> observed;
        if (observer_) observed = observer_->environment(task_, world);
        const std::unique_ptr<Policy> policy = make_policy(options_.policy, context_);
        std::unique_ptr<RunRecorder> recorder;
        if (!options_.view.empty()) recorder = std::make_unique<RunRecorder>(belief);
        teller_.begin(number);
        const auto watch = [&](const Event& event, const Belief& now) {
            teller_.tell(event, now);
            if (recorder) recorder->tell(event, now);
        };
        PolicyResult result;
        std::string error;
        try {
            result =
                run_policy(*policy, context_, belief, observed ? *observed : world, run_.budget(), watch);
        } catch (const ObserverError& broken) {
            error = broken.what();
        }
        const double seconds = processor_seconds() - start;

        BeliefRun run = judge_belief_run(*task_, first, world, result.run.status);
        run.processor_seconds = seconds;
        run.world = number;
        set_searches(run, result.run.plan_seconds);
        if (!run.false_success) run.message = result.run.message;
        if (!error.empty()) {
            run.status = "observer failed";
            run.message = run.error = error;
        }
        for (std::uint32_t action : result.run.actions)
            run.actions.push_back(task_->physical->operator_name(OperatorId(action)));
        run.length = length(*task_, result);
        if (yardstick_) {
            const BeliefYardstick::Costs costs = yardstick_->costs(first, run_.budget());
            run.policy_cost = costs.policy;
            run.omniscient_cost = costs.omniscient;
        }
        if (recorder) page_ = recorder->page(options_.problem, summary(run));
        run_.update([&](Report& report) { report.runs.push_back(run); });
        runs_.push_back(std::move(run));
    }

    static std::string summary(const BeliefRun& run) {
        std::string text = std::to_string(run.actions.size()) + " actions, " + std::to_string(run.plans) +
                           " plans, " + seconds_text(run.processor_seconds) + " of processor time: ";
        if (run.false_success) return text + "the goal is believed to hold, but does not: " + run.message;
        text += run.success ? "the goal is reached" : run.status;
        return run.message.empty() ? text : text + " (" + run.message + ")";
    }

    Run& run_;
    const BeliefOptions& options_;
    std::shared_ptr<const BeliefTask> task_;
    BeliefWorlds worlds_;
    BeliefTeller teller_;
    PolicyContext context_;
    std::unique_ptr<BeliefYardstick> yardstick_;
    std::unique_ptr<BeliefObserver> observer_;
    std::vector<BeliefRun> runs_;
    std::string page_;
};

Ending run_task(Run& run, const BeliefOptions& options) {
    const std::shared_ptr<const ContingentTask> source = run.load_contingent(options.worlds);
    if (!source->hidden_objects.empty()) return explore_belief_task(run, options, source);
    run.set_phase("grounding");
    const GroundBeliefResult ground = ground_belief(source, run.budget());
    if (!ground.task) return run.stopped(ground.stop);
    CompilationOptions compilation_options;
    compilation_options.risk = options.risk;
    const auto compilation = std::make_shared<const Compilation>(ground.task, compilation_options);
    auto planner = std::make_shared<const KnowledgePlanner>(compilation, run.budget());
    if (options.offline) return make_offline_plan(run, options, *planner);
    return Runner(run, options, std::move(planner))();
}

}  // namespace

int run_belief(const BeliefOptions& options) {
    Run run(options, "belief", options.domain, options.problem);
    return run.execute([&] { return run_task(run, options); });
}

}  // namespace praxis::app
