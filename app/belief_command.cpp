#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "app/belief_offline.hpp"
#include "app/belief_table.hpp"
#include "app/belief_teller.hpp"
#include "app/belief_worlds.hpp"
#include "app/belief_yardstick.hpp"
#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "belief/check_run.hpp"
#include "belief/policies/prepared_policy.hpp"
#include "belief/policies/run_policy.hpp"
#include "belief/simulated_world.hpp"
#include "belief/view/run_page.hpp"

namespace praxis::app {
namespace {

using namespace praxis::belief;

AgentOptions agent_options(const BeliefOptions& options, std::size_t axioms) {
    using Mode = BeliefOptions::Mode;
    AgentOptions result = default_agent_options(axioms);
    result.most_steps = options.max_steps;
    if (!options.search.empty()) result.first = configuration(options.search);
    result.first.seed = result.second.seed = options.seed;
    if (options.plan_time) {
        result.second_seconds = *options.plan_time;
        result.plan_seconds = std::min(result.plan_seconds, result.second_seconds);
    }
    const bool weigh = options.mode == Mode::bayes || (options.mode == Mode::automatic && options.noise > 0);
    if (weigh) result.accept = options.accept;
    // Policies that choose by themselves do not weigh readings; a contradiction must not end their runs.
    result.ignore_contradictions = weigh || options.mode == Mode::sticky;
    return result;
}

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
          teller_(*task_, worlds_.count() == 1, !options.trace.empty()) {
        context_.options = agent_options(options, planner->compilation().task()->axioms.size());
        context_.planner = std::move(planner);
        if (!options.view.empty() && worlds_.count() != 1)
            throw std::invalid_argument("--view shows one run, and there are " +
                                        std::to_string(worlds_.count()) + "; add --" +
                                        (options.samples ? "seeds" : "runs") + " 1");
    }

    Ending operator()() {
        if (options_.optimum) measure_world();
        // Weighing readings and following a plan for right ones do not go together.
        if (options_.policy == "best" && options_.noise == 0 && options_.search.empty())
            context_.prepared = prepare_best(task_, run_.budget());
        run_.set_phase("acting");
        for (std::size_t i = 0; i < worlds_.count(); ++i) {
            if (run_.budget().exhausted() != Stop::none && !runs_.empty()) break;
            act(i, worlds_.next(i));
        }
        const bool single = worlds_.count() == 1;
        std::string text = single ? teller_.text() : belief_table(runs_, options_.optimum);
        if (single && options_.optimum) text += belief_comparison(runs_[0]);
        if (options_.trace != "-" && options_.view != "-") run_.set_result(std::move(text));
        if (!options_.trace.empty()) write_file(options_.trace, teller_.trace());
        if (!options_.view.empty()) write_file(options_.view, page_);
        return ending();
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
        SimulatedWorld world(task_, first, options_.noise, options_.seed + number);
        const std::unique_ptr<Policy> policy = make_policy(options_.policy, context_);
        std::unique_ptr<RunRecorder> recorder;
        if (!options_.view.empty()) recorder = std::make_unique<RunRecorder>(belief);
        teller_.begin(number);
        const auto watch = [&](const Event& event, const Belief& now) {
            teller_.tell(event, now);
            if (recorder) recorder->tell(event, now);
        };
        const PolicyResult result = run_policy(*policy, context_, belief, world, run_.budget(), watch);

        BeliefRun run;
        run.processor_seconds = processor_seconds() - start;
        run.world = number;
        run.status = to_string(result.run.status);
        run.search_seconds =
            std::accumulate(result.run.plan_seconds.begin(), result.run.plan_seconds.end(), 0.0);
        for (double seconds : result.run.plan_seconds)
            run.longest_search = std::max(run.longest_search, seconds);
        run.plans = result.run.plans;
        run.message = result.run.message;
        for (std::uint32_t action : result.run.actions)
            run.actions.push_back(task_->physical->operator_name(OperatorId(action)));
        run.length = length(*task_, result);
        const Verdict verdict = check_run(*task_, first, result.run.actions, world.after_chance());
        run.success = result.run.status == RunStatus::reached && verdict.valid;
        run.false_success = result.run.status == RunStatus::reached && !verdict.valid;
        if (run.false_success) run.message = verdict.reason;
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

    Ending ending() const {
        const bool all =
            std::all_of(runs_.begin(), runs_.end(), [](const BeliefRun& r) { return r.success; });
        const bool complete = runs_.size() == worlds_.count();
        if (const Stop stop = run_.budget().exhausted(); stop != Stop::none && !(all && complete))
            return run_.stopped(stop);
        if (worlds_.count() == 1 && runs_[0].false_success)
            return {"failed", kFailed, "the goal is believed to hold, but does not: " + runs_[0].message};
        return all ? Ending{"solved", kSolved, ""} : Ending{"failed", kFailed, ""};
    }

    Run& run_;
    const BeliefOptions& options_;
    std::shared_ptr<const BeliefTask> task_;
    BeliefWorlds worlds_;
    BeliefTeller teller_;
    PolicyContext context_;
    std::unique_ptr<BeliefYardstick> yardstick_;
    std::vector<BeliefRun> runs_;
    std::string page_;
};

Ending run_task(Run& run, const BeliefOptions& options) {
    const std::shared_ptr<const ContingentTask> source = run.load_contingent(options.worlds);
    if (!source->hidden_objects.empty())
        return {"unsupported", kUnsupported,
                "plan: error: ':hidden-objects' needs a program that explores (praxis::belief::explore); the "
                "command acts with all objects known"};
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
