#include "search/validate.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/run.hpp"

namespace praxis::app {
namespace {

Source read_plan(const std::string& path) {
    Source source{path == "-" ? "<stdin>" : path, {}};
    std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
    if (!file) throw InputError(path + ": error: cannot read the plan: " + std::strerror(errno));
    char block[1 << 16];
    std::size_t size = 0;
    while ((size = std::fread(block, 1, sizeof block, file)) > 0) source.text.append(block, size);
    const int error = std::ferror(file) ? errno : 0;
    if (file != stdin) std::fclose(file);
    if (error) throw InputError(path + ": error: cannot read the plan: " + std::strerror(error));
    return source;
}

Ending validate(Run& run, const ValidateOptions& options) {
    const Task task = run.load();
    const ParsedPlan parsed = parse_plan(read_plan(options.plan), *task);
    run.set_phase("executing the plan");
    Verdict verdict = praxis::validate(*task, parsed.plan);
    std::string message;
    if (!verdict.valid) {
        message = "invalid plan: " + verdict.reason;
    } else if (parsed.cost_claimed && parsed.plan.cost != verdict.cost) {
        verdict.valid = false;
        message = "invalid plan: it claims cost " + parsed.plan.cost.to_string() + " but costs " +
                  verdict.cost.to_string();
    }
    const bool valid = verdict.valid;
    const std::string cost = verdict.cost.to_string();
    run.update([&](Report& report) {
        report.plan = parsed.plan;
        report.plan->cost = verdict.cost;
        report.verdict = std::move(verdict);
        report.message = message;
    });
    if (!valid) {
        run.set_result(message + "\n");
        return {"invalid", kInvalidPlan, ""};
    }
    run.set_result("valid plan: " + std::to_string(parsed.plan.steps.size()) + " actions, cost " + cost +
                   "\n");
    return {"valid", kSolved, ""};
}

}  // namespace

int run_validate(const ValidateOptions& options) {
    Run run(options, "validate", options.domain, options.problem);
    return run.execute([&] { return validate(run, options); });
}

}  // namespace praxis::app
