#include "tests/app/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace praxis::test {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() { EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0); }
    ~Pipe() {
        close(0);
        close(1);
    }
    void close(int end) {
        if (ends[end] >= 0) ::close(ends[end]);
        ends[end] = -1;
    }
};

void exec(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    argv.push_back(const_cast<char*>(program.c_str()));
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(program.c_str(), argv.data());
    ::_exit(126);
}

/// Reads what there is; false at the end.
bool drain(int descriptor, std::string& text) {
    char block[1 << 14];
    const ssize_t size = ::read(descriptor, block, sizeof block);
    if (size > 0) text.append(block, static_cast<std::size_t>(size));
    return size > 0;
}

}  // namespace

Outcome plan(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
    return run(PRAXIS_PLAN_COMMAND, arguments, circumstances);
}

Outcome run(const std::string& program, const std::vector<std::string>& arguments,
            const Circumstances& circumstances) {
    Pipe in;
    Pipe out;
    Pipe err;
    const auto start = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(in.ends[0], 0);
        ::dup2(out.ends[1], 1);
        ::dup2(err.ends[1], 2);
        if (circumstances.prepare) circumstances.prepare();
        exec(program, arguments);
    }
    in.close(0);
    out.close(1);
    err.close(1);
    if (circumstances.close_output) out.close(0);
    std::signal(SIGPIPE, SIG_IGN);
    std::size_t written = 0;
    ::fcntl(in.ends[1], F_SETFL, O_NONBLOCK);

    Outcome outcome;
    std::size_t next_signal = 0;
    std::optional<double> ready;
    if (!circumstances.ready) ready = 0;
    bool late = false;
    while (out.ends[0] >= 0 || err.ends[0] >= 0) {
        if (written == circumstances.input.size()) in.close(1);
        pollfd waits[3] = {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}, {in.ends[1], POLLOUT, 0}};
        ::poll(waits, 3, 5);
        if (out.ends[0] >= 0 && waits[0].revents && !drain(out.ends[0], outcome.out)) out.close(0);
        if (err.ends[0] >= 0 && waits[1].revents && !drain(err.ends[0], outcome.err)) err.close(0);
        if (in.ends[1] >= 0 && waits[2].revents) {
            const ssize_t size = ::write(in.ends[1], circumstances.input.data() + written,
                                         circumstances.input.size() - written);
            written = size < 0 ? circumstances.input.size() : written + static_cast<std::size_t>(size);
        }
        const auto& signals = circumstances.signals;
        if (!ready && next_signal < signals.size() && circumstances.ready()) ready = elapsed();
        if (ready && next_signal < signals.size() && elapsed() - *ready >= signals[next_signal].first)
            ::kill(child, signals[next_signal++].second);
        if (elapsed() > 60 && !late) {
            ADD_FAILURE() << "the command does not end";
            ::kill(child, SIGKILL);
            late = true;
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    outcome.seconds = elapsed();
    outcome.killed = WIFSIGNALED(status);
    outcome.exit_code = outcome.killed ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return outcome;
}

TemporaryFolder::TemporaryFolder() {
    path_ = (std::filesystem::temp_directory_path() / "praxis-test-XXXXXX").string();
    if (!::mkdtemp(path_.data())) ADD_FAILURE() << "no temporary folder";
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
    return path_ + "/" + name;
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string domain_of(const std::string& name) {
    return PRAXIS_SOURCE_DIR "/domains/" + name + "/domain.pddl";
}

std::string problem_of(const std::string& name, const std::string& size) {
    return PRAXIS_SOURCE_DIR "/problems/" + name + "/" + size + ".pddl";
}

}  // namespace praxis::test
