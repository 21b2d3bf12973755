#include <cstdio>
#include <stdexcept>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "search/session.hpp"
#include "search/validate.hpp"

namespace praxis::app {
namespace {

/// A plan that does not pass the validator: a fault of ours.
class InvalidPlan : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

std::string bug_report(const PlanOptions& options, const std::string& expression, const Verdict& verdict,
                       const std::string& plan) {
    return "plan: internal error: the plan found is not valid, so it is not given out.\nThis is a bug. "
           "Please report it with "
           "the two files and these lines:\n  praxis " PRAXIS_VERSION "; domain " +
           (options.domain.empty() ? "(beside the problem)" : options.domain) + "; problem " +
           options.problem + "\n  --search '" + expression + "' --seed " + std::to_string(options.seed) +
           " --threads " + std::to_string(options.threads) + "\n  " + verdict.reason + "\n" + plan;
}

/// Takes the plans as they are found: checks them, keeps the best, writes the plan files.
class PlanSink {
  public:
    PlanSink(Run& run, const PlanOptions& options, Task task, std::string expression)
        : run_(run),
          options_(options),
          task_(std::move(task)),
          expression_(std::move(expression)),
          files_(options.plan_file == "-" ? "" : options.plan_file) {}

    /// Throws InvalidPlan or OutputError.
    void take(const Plan& plan) {
        if (last_ && *last_ == plan.steps) return;
        last_ = plan.steps;
        std::string text = to_string(plan, *task_);
        if (options_.check) {
            const Verdict verdict = validate(*task_, plan);
            if (!verdict.valid || verdict.cost != plan.cost)
                throw InvalidPlan(bug_report(options_, expression_, verdict, text));
        }
        run_.update([&](Report& report) { report.plan = plan; });
        run_.set_result(text);
        files_.write(text);
    }

  private:
    Run& run_;
    const PlanOptions& options_;
    Task task_;
    std::string expression_;
    PlanFiles files_;
    std::optional<std::vector<PlanStep>> last_;
};

std::string phases_text(const std::vector<PhaseStatistics>& phases) {
    std::string text;
    for (const PhaseStatistics& phase : phases) {
        text += phase.name + ": " + seconds_text(phase.seconds);
        for (const auto& [name, count] : phase.counts) text += ", " + count_text(count) + " " + name;
        text += "\n";
    }
    return text;
}

std::string statistics_text(const SearchStatistics& statistics) {
    char bytes[32];
    std::snprintf(bytes, sizeof bytes, "%.1f", statistics.bytes_per_state);
    return "search: " + seconds_text(statistics.seconds) + ", expanded " + count_text(statistics.expanded) +
           ", evaluated " + count_text(statistics.evaluated) + ", generated " +
           count_text(statistics.generated) + ", reopened " + count_text(statistics.reopened) +
           ", dead ends " + count_text(statistics.dead_ends) + ", states " +
           count_text(statistics.registered_states) + " of " + bytes + " bytes";
}

std::string summary(const Result& result) {
    std::string text;
    if (result.plan) {
        text = "plan found: " + count_text(result.plan->steps.size()) + " actions, cost " +
               result.plan->cost.to_string() + (result.optimal ? " (optimal)" : "");
        if (result.status == Status::out_of_time) text += "; the time limit ended the search";
        if (result.status == Status::out_of_memory) text += "; the memory limit ended the search";
        if (result.status == Status::interrupted) text += "; a signal ended the search";
    } else if (result.status == Status::unsolvable_early || result.status == Status::unsolvable) {
        text = "there is no plan: proved ";
        text += result.status == Status::unsolvable ? "by the search" : "before the search";
    } else if (result.status == Status::failed) {
        text = "no plan found, and no proof that there is none";
    } else {
        text = "no plan found";
    }
    return text + "; " + seconds_text(elapsed_seconds()) + ", " + bytes_text(peak_memory());
}

Ending ending_of(const Result& result, const Run& run) {
    switch (result.status) {
        case Status::out_of_time:
            return run.stopped(Stop::time);
        case Status::out_of_memory:
            return run.stopped(Stop::memory);
        case Status::interrupted:
            return run.stopped(Stop::interrupted);
        default:
            break;
    }
    return {status_name(result.status), exit_code(result.status), ""};
}

Ending plan(Run& run, const PlanOptions& options) {
    Configuration configured = options.search.empty() ? alias(options.alias) : configuration(options.search);
    configured.seed = options.seed;
    configured.threads = options.threads;
    run.update([&](Report& report) {
        report.configuration = configured;
        if (options.search.empty()) report.alias = options.alias;
    });
    const Task task = run.load();
    for (const Source& source : task->sources->files)
        if (!options.plan_file.empty() && same_file(options.plan_file, source.name))
            throw std::invalid_argument("the plan file would replace '" + source.name + "'");
    PlanSink sink(run, options, task, configured.expression);
    run.set_phase("grounding");
    SessionOptions session_options;
    session_options.replanning = false;
    // Not torn down: the process ends soon, and freeing large tables would only cost time.
    Session& session = *new Session(task, session_options, run.budget());
    run.update([&](Report& report) { report.phases = session.phases(); });
    if (run.verbose()) run.say(phases_text(session.phases()) + "configuration: " + configured.expression);

    if (session.lifted()) run.say("too large to ground: a lifted search takes over");
    run.set_phase(session.lifted() ? "lifted search" : "search");
    std::exception_ptr fault;
    Callbacks callbacks;
    std::stop_source enough;
    callbacks.on_plan = [&](const Plan& found) {
        try {
            if (!fault) sink.take(found);
        } catch (...) {
            fault = std::current_exception();
        }
    };
    callbacks.on_progress = [&](const SearchStatistics& statistics) {
        run.update([&](Report& report) { report.statistics = statistics; });
    };
    const Result result = session.plan(configured, run.budget(), callbacks);
    if (fault) std::rethrow_exception(fault);
    if (result.plan) sink.take(*result.plan);
    run.update([&](Report& report) {
        report.statistics = result.statistics;
        report.optimal = result.optimal;
        report.lifted = result.lifted;
    });
    if (run.verbose()) run.say(statistics_text(result.statistics));
    Ending ending = ending_of(result, run);
    if (result.plan) ending.message.clear();
    run.say(summary(result));
    return ending;
}

}  // namespace

int run_plan(const PlanOptions& options) {
    Run run(options, "plan", options.domain, options.problem);
    return run.execute([&]() -> Ending {
        try {
            return plan(run, options);
        } catch (const InvalidPlan& error) {
            run.set_result("");
            return {"internal_error", kInternalError, error.what()};
        }
    });
}

}  // namespace praxis::app
