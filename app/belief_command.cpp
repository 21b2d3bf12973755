#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "belief/agent.hpp"
#include "belief/check_run.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::app {
namespace {

using namespace praxis::belief;

/// The worlds to act in.
std::vector<WorldState> choose_worlds(const BeliefTask& task, const BeliefOptions& options) {
    std::vector<WorldState> worlds;
    if (options.samples || task.worlds.size() == 0) {
        Random random(options.seed);
        const std::size_t count = options.samples.value_or(options.runs.value_or(1));
        for (std::size_t i = 0; i < count; ++i) {
            std::optional<WorldState> world = sample_world(task, random);
            if (!world) throw std::invalid_argument("no first state satisfies the initial description");
            worlds.push_back(std::move(*world));
        }
        return worlds;
    }
    const std::size_t all = task.worlds.size();
    const std::size_t count = std::min(all, options.runs.value_or(all));
    for (std::size_t i = 0; i < count; ++i) worlds.push_back(hidden_world(task, i * all / count));
    return worlds;
}

/// Writes the events of the runs: for people, or as lines of JSON.
class Teller {
  public:
    Teller(const BeliefTask& task, const BeliefOptions& options) : task_(task), options_(options) {}

    void begin(std::size_t world) { world_ = world; }
    void tell(const Event& event) {
        const std::string action = event.action == Environment::kStart
                                       ? ""
                                       : task_.physical->operator_name(OperatorId(event.action));
        if (!options_.trace.empty()) tell_json(event, action);
        switch (event.kind) {
            case Event::Kind::planned:
                text_ += "; plan of " + std::to_string(event.plan_length) + " actions (" + event.text + ")\n";
                break;
            case Event::Kind::executed:
                text_ += action + "\n";
                break;
            case Event::Kind::failed:
                text_ += "; failed: " + action + " " + event.text + "\n";
                break;
            case Event::Kind::read:
                text_ += ";   read " + event.text + "\n";
                break;
            case Event::Kind::finished:
                text_ += "; " + event.text + "\n";
                break;
        }
    }
    const std::string& text() const { return text_; }
    void write_trace() const {
        if (!options_.trace.empty()) write_file(options_.trace, trace_);
    }

  private:
    void tell_json(const Event& event, const std::string& action) {
        static constexpr const char* kKinds[] = {"planned", "executed", "failed", "read", "finished"};
        nlohmann::ordered_json line{{"world", world_}, {"event", kKinds[static_cast<int>(event.kind)]}};
        if (!action.empty()) line["action"] = action;
        if (!event.text.empty()) line["text"] = event.text;
        if (event.kind == Event::Kind::planned) {
            line["actions"] = event.plan_length;
            line["processor_seconds"] = event.seconds;
        }
        trace_ += line.dump() + "\n";
    }

    const BeliefTask& task_;
    const BeliefOptions& options_;
    std::size_t world_ = 0;
    std::string text_;
    std::string trace_;
};

BeliefRun run_world(const std::shared_ptr<const KnowledgePlanner>& planner, const BeliefOptions& options,
                    std::size_t number, const WorldState& first, const Budget& budget, Teller& teller) {
    const std::shared_ptr<const Compilation> compilation = planner->shared_compilation();
    const std::shared_ptr<const BeliefTask> task = compilation->shared_belief();
    AgentOptions agent_options = default_agent_options();
    agent_options.most_steps = options.max_steps;
    if (!options.search.empty()) agent_options.first = configuration(options.search);
    agent_options.first.seed = agent_options.second.seed = options.seed;
    const Agent agent(planner, agent_options);
    const double start = processor_seconds();
    Belief belief(compilation);
    SimulatedWorld world(task, first, options.noise, options.seed + number);
    teller.begin(number);
    const RunResult result =
        agent.run(belief, world, budget, [&](const Event& event, const Belief&) { teller.tell(event); });
    BeliefRun run;
    run.world = number;
    run.status = to_string(result.status);
    run.processor_seconds = processor_seconds() - start;
    run.search_seconds = std::accumulate(result.plan_seconds.begin(), result.plan_seconds.end(), 0.0);
    for (double seconds : result.plan_seconds) run.longest_search = std::max(run.longest_search, seconds);
    run.plans = result.plans;
    run.message = result.message;
    for (std::uint32_t action : result.actions)
        run.actions.push_back(task->physical->operator_name(OperatorId(action)));
    const Verdict verdict = check_run(*task, first, result.actions);
    run.success = result.status == RunStatus::reached && verdict.valid;
    run.false_success = result.status == RunStatus::reached && !verdict.valid;
    if (run.false_success) run.message = verdict.reason;
    return run;
}

std::string table(const std::vector<BeliefRun>& runs) {
    std::string text;
    char line[256];
    std::size_t successes = 0, false_successes = 0, actions = 0, plans = 0;
    double seconds = 0;
    for (const BeliefRun& run : runs) {
        successes += run.success;
        false_successes += run.false_success;
        actions += run.actions.size();
        plans += run.plans;
        seconds += run.processor_seconds;
    }
    const auto count = static_cast<double>(runs.size());
    std::snprintf(line, sizeof line,
                  "%zu runs: %zu reached the goal (%.1f %%), %zu believed so wrongly; means: %.1f actions, "
                  "%.1f plans, %.4f s of processor time\n",
                  runs.size(), successes, 100.0 * static_cast<double>(successes) / count, false_successes,
                  static_cast<double>(actions) / count, static_cast<double>(plans) / count, seconds / count);
    text += line;
    for (const BeliefRun& run : runs) {
        if (run.success) continue;
        text += "world " + std::to_string(run.world) + ": " + run.status;
        if (!run.message.empty()) text += " (" + run.message + ")";
        text += "\n";
    }
    return text;
}

Ending act(Run& run, const BeliefOptions& options) {
    const std::shared_ptr<const ContingentTask> source = run.load_contingent(options.worlds);
    run.set_phase("grounding");
    const GroundBeliefResult ground = ground_belief(source, run.budget());
    if (!ground.task) return run.stopped(ground.stop);
    const auto compilation = std::make_shared<const Compilation>(ground.task);
    const auto planner = std::make_shared<const KnowledgePlanner>(compilation, run.budget());
    const std::vector<WorldState> worlds = choose_worlds(*ground.task, options);
    run.set_phase("acting");
    Teller teller(*ground.task, options);
    std::vector<BeliefRun> runs;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        if (const Stop stop = run.budget().exhausted(); stop != Stop::none && !runs.empty()) break;
        runs.push_back(run_world(planner, options, i, worlds[i], run.budget(), teller));
        run.update([&](Report& report) { report.runs = runs; });
    }
    teller.write_trace();
    run.set_result(worlds.size() == 1 ? teller.text() : table(runs));
    const bool all = std::all_of(runs.begin(), runs.end(), [](const BeliefRun& r) { return r.success; });
    if (const Stop stop = run.budget().exhausted(); stop != Stop::none && !all) return run.stopped(stop);
    if (worlds.size() == 1 && runs[0].false_success)
        return {"failed", kFailed, "the goal is believed to hold, but does not: " + runs[0].message};
    return all ? Ending{"solved", kSolved, ""} : Ending{"failed", kFailed, ""};
}

}  // namespace

int run_belief(const BeliefOptions& options) {
    Run run(options, "belief", options.domain, options.problem);
    return run.execute([&] { return act(run, options); });
}

}  // namespace praxis::app
