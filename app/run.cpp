#include "app/run.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "app/exit_code.hpp"
#include "app/memory_guard.hpp"
#include "app/output.hpp"

namespace praxis::app {
namespace {

/// Processor seconds kept back from the system's limit, for the ending.
constexpr double kProcessorReserve = 0.25;
Run* current = nullptr;

std::string without_final_newline(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace

Run::Run(const CommonOptions& options, std::string command, std::string domain, std::string problem)
    : options_(options) {
    report_.command = std::move(command);
    report_.domain = std::move(domain);
    report_.problem = std::move(problem);
    progress_ = std::make_unique<Progress>(!options.quiet);

    std::optional<std::size_t> memory;
    if (options.memory_limit_mb) memory = static_cast<std::size_t>(*options.memory_limit_mb * (1 << 20));
    guard_memory(memory);
    budget_.limit_memory(memory ? *memory : usable_memory());
    std::optional<Watcher::Clock::time_point> deadline;
    if (options.time_limit) {
        const double left = *options.time_limit - elapsed_seconds();
        deadline = Watcher::Clock::now() +
                   std::chrono::duration_cast<Watcher::Clock::duration>(std::chrono::duration<double>(left));
        budget_.limit_wall_time(left);
    }
    rlimit processor{};
    if (getrlimit(RLIMIT_CPU, &processor) == 0 && processor.rlim_cur != RLIM_INFINITY)
        budget_.limit_processor_time(static_cast<double>(processor.rlim_cur) - processor_seconds() -
                                     kProcessorReserve);
    std::signal(SIGPIPE, SIG_IGN);
    Watcher::Hooks hooks;
    hooks.on_overrun = [this](Stop stop) { overrun(stop); };
    if (!options.quiet) hooks.on_tick = [this] { tick(); };
    hooks.tick = progress_->interval();
    watcher_ = std::make_unique<Watcher>(deadline, std::move(hooks));
    budget_.stop_with(watcher_->token());
    current = this;
    std::set_terminate(&Run::on_terminate);
}

std::pair<std::string, std::string> Run::files() {
    set_phase("reading");
    std::string domain;
    std::string problem;
    {
        const std::scoped_lock lock(mutex_);
        domain = report_.domain;
        problem = report_.problem;
    }
    if (domain.empty()) {
        domain = find_domain_file(problem);
        update([&](Report& report) { report.domain = domain; });
    }
    return {domain, problem};
}

void Run::say_warnings(const std::vector<Diagnostic>& warnings, const Sources& sources) {
    if (options_.quiet) return;
    for (const Diagnostic& warning : warnings) say(without_final_newline(to_string(warning, sources)));
}

Task Run::load() {
    const auto [domain, problem] = files();
    LoadResult loaded = load_with_warnings(domain, problem);
    say_warnings(loaded.warnings, *loaded.task->sources);
    update([&](Report& report) { report.task = loaded.task; });
    return loaded.task;
}

std::shared_ptr<const ContingentTask> Run::load_contingent(const std::vector<std::string>& worlds) {
    const auto [domain, problem] = files();
    ContingentLoadResult loaded = praxis::load_contingent(domain, problem, worlds);
    say_warnings(loaded.warnings, *loaded.task->task->sources);
    update([&](Report& report) { report.task = loaded.task->task; });
    return loaded.task;
}

void Run::set_result(std::string text) {
    const std::scoped_lock lock(mutex_);
    result_ = std::move(text);
}

void Run::at_end(std::function<std::string(Report&)> conclude) {
    const std::scoped_lock lock(mutex_);
    conclude_ = std::move(conclude);
}

void Run::set_share(double done, std::string text) {
    const std::scoped_lock lock(mutex_);
    progress_->set_share(done, std::move(text));
}

void Run::set_detail(std::string text) {
    const std::scoped_lock lock(mutex_);
    progress_->set_detail(std::move(text));
}

void Run::set_phase(const char* phase) {
    const std::scoped_lock lock(mutex_);
    progress_->set_phase(phase);
}

void Run::say(const std::string& line) {
    if (options_.quiet) return;
    const std::scoped_lock lock(mutex_);
    progress_->print(line);
}

void Run::tick() {
    const std::scoped_lock lock(mutex_);
    if (report_.statistics) progress_->set_statistics(*report_.statistics);
    progress_->show();
}

Ending Run::stopped(Stop stop) const {
    if (stop == Stop::memory) return {"out_of_memory", kOutOfMemory, "the memory limit is reached"};
    const int signal = watcher_ ? watcher_->signal() : 0;
    if (stop == Stop::interrupted && signal != 0 && signal != SIGXCPU)
        return {"interrupted", kSignalBase + signal, "stopped by a signal"};
    return {"out_of_time", kOutOfTime, "the time limit is reached"};
}

Ending Run::end_by_exception() const {
    try {
        throw;
    } catch (const UnsupportedError& error) {
        return {"unsupported", kUnsupported, without_final_newline(error.what())};
    } catch (const InputError& error) {
        return {"input_error", kInputError, without_final_newline(error.what())};
    } catch (const std::invalid_argument& error) {
        return {"input_error", kInputError, std::string("plan: error: ") + error.what()};
    } catch (const OutputError& error) {
        return {"output_error", kOutputError, std::string("plan: error: ") + error.what()};
    } catch (const std::bad_alloc&) {
        return stopped(Stop::memory);
    } catch (const std::exception& error) {
        return {"internal_error", kInternalError, std::string("plan: internal error: ") + error.what()};
    }
}

int Run::execute(const std::function<Ending()>& body) {
    Ending ending;
    try {
        ending = body();
    } catch (...) {
        ending = end_by_exception();
    }
    // From here on the watcher keeps out; if it was first, it ends the process while this thread waits.
    const std::scoped_lock lock(mutex_);
    watcher_->finish();
    return finish(ending);
}

int Run::finish(const Ending& ending) {
    progress_->clear();
    Ending last = ending;
    // A plan once found is never lost to a later limit or signal.
    if (!result_.empty() && last.exit_code != kInternalError && last.exit_code != kOutputError &&
        report_.command == "plan")
        last.exit_code = kSolved;
    try {
        if (conclude_) result_ = std::exchange(conclude_, nullptr)(report_);
    } catch (...) {
        last = end_by_exception();
    }
    try {
        if (!result_.empty() && options_.json != "-") write_standard_output(result_);
    } catch (const OutputError& error) {
        last = {"output_error", kOutputError, std::string("plan: error: ") + error.what()};
    }
    report_.status = last.status;
    report_.exit_code = last.exit_code;
    if (!last.message.empty()) report_.message = last.message;
    if (!last.message.empty() && (!options_.quiet || last.exit_code >= kInternalError))
        std::fprintf(stderr, "%s\n", last.message.c_str());
    if (!options_.json.empty()) {
        try {
            write_file(options_.json, to_json(report_));
        } catch (const OutputError& error) {
            std::fprintf(stderr, "plan: error: %s\n", error.what());
            return kOutputError;
        }
    }
    return last.exit_code;
}

void Run::overrun(Stop stop) {
    const std::scoped_lock lock(mutex_);
    _exit(finish(stopped(stop)));
}

void Run::on_terminate() {
    Ending ending{"internal_error", kInternalError,
                  "plan: internal error: a fault where none can be handled"};
    if (memory_failed()) ending = current->stopped(Stop::memory);
    // The mutex may be this thread's own, and so may those of the conclusion; nothing else matters any more.
    static_cast<void>(current->mutex_.try_lock());
    current->conclude_ = nullptr;
    current->watcher_->finish();
    _exit(current->finish(ending));
}

}  // namespace praxis::app
