#include "practice/loop/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "parser/diagnostic.hpp"

namespace praxis::practice {

namespace {

using nlohmann::json;

constexpr int kFormat = 1;
constexpr const char* kMagic = "praxis practice journal";

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw std::system_error(errno, std::generic_category(), path + ": cannot " + what + " the journal");
}

json numbers(std::int32_t first, const std::vector<std::int32_t>& others) {
    json list = json::array({first});
    for (std::int32_t number : others) list.push_back(number);
    return list;
}

void require_finite(const std::vector<double>& numbers, const char* what) {
    if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
        throw std::invalid_argument(std::string("a practice journal is given ") + what +
                                    " that is not finite");
}

std::string line_of(const JournalRecord& record) {
    std::visit([](const auto& any) { require_finite(any.state, "a number of a state"); }, record);
    json line;
    if (const auto* task = std::get_if<JournalTask>(&record)) {
        line["task"] = json::array();
        for (const GroundAtom& atom : task->goal)
            line["task"].push_back(numbers(atom.predicate, atom.objects));
        line["state"] = task->state;
    } else {
        const auto& step = std::get<JournalStep>(record);
        require_finite(step.parameters, "a parameter");
        line["skill"] = numbers(step.skill.schema, step.skill.objects);
        line["parameters"] = step.parameters;
        line["state"] = step.state;
    }
    return line.dump();
}

std::vector<double> finite_numbers(const json& list) {
    auto result = list.get<std::vector<double>>();
    if (!std::ranges::all_of(result, [](double x) { return std::isfinite(x); }))
        throw std::domain_error("a number is not finite");
    return result;
}

template <class Item>
Item item_of(const json& list) {
    auto all = list.get<std::vector<std::int32_t>>();
    if (all.empty()) throw std::domain_error("an empty name");
    return {all[0], {all.begin() + 1, all.end()}};
}

JournalRecord record_of(const json& line) {
    if (line.contains("task")) {
        JournalTask task;
        for (const json& atom : line.at("task")) task.goal.push_back(item_of<GroundAtom>(atom));
        task.state = finite_numbers(line.at("state"));
        return task;
    }
    return JournalStep{item_of<GroundSkill>(line.at("skill")), finite_numbers(line.at("parameters")),
                       finite_numbers(line.at("state"))};
}

/// What a crash may have left of a first line.
bool is_torn_header(const std::string& text) {
    const std::string start = "{\"" + std::string(kMagic) + "\":";
    return text.starts_with(start) || start.starts_with(text);
}

std::string read_all(int file, const std::string& path) {
    std::string text;
    char buffer[1 << 16];
    for (;;) {
        const ssize_t count = ::read(file, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, "read");
        if (count == 0) return text;
        text.append(buffer, static_cast<std::size_t>(count));
    }
}

}  // namespace

Journal::Journal(const std::string& path, const std::string& settings) : path_(path) {
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file_ < 0) fail(path_, "open");
    try {
        lock();
        read(settings);
    } catch (...) {
        ::close(file_);
        throw;
    }
}

Journal::~Journal() {
    ::close(file_);
}

void Journal::lock() {
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno != EWOULDBLOCK) fail(path_, "lock");
    throw InputError(path_ +
                     ": error: another run of practice is writing this journal; wait until it ends, or give "
                     "another name\n");
}

void Journal::read(const std::string& settings) {
    struct stat status {};
    if (::fstat(file_, &status) != 0) fail(path_, "read");
    if (!S_ISREG(status.st_mode)) throw InputError(path_ + ": error: a practice journal must be a file\n");
    const std::string text = read_all(file_, path_);
    std::size_t begin = 0;
    int number = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        ++number;
        const auto refuse = [&](const std::string& why) {
            throw InputError(path_ + ":" + std::to_string(number) + ": error: " + why + "\n");
        };
        const json line = json::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                      text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
        if (!line.is_object()) refuse("this is no line of a practice journal");
        try {
            if (number > 1) {
                records_.push_back(record_of(line));
                continue;
            }
            if (line.at(kMagic).get<int>() != kFormat)
                refuse("the journal is of another version of the format");
            if (const auto other = line.at("settings").get<std::string>(); other != settings)
                refuse("the journal was made with other settings (" + other +
                       "); give it another name, or practise with those");
        } catch (const json::exception& error) {
            refuse(std::string("the journal is damaged: ") + error.what());
        } catch (const std::domain_error& error) {
            refuse(std::string("the journal is damaged: ") + error.what());
        }
    }
    if (number == 0 && !is_torn_header(text))
        throw InputError(path_ + ":1: error: this is no practice journal; give another name\n");
    if (::ftruncate(file_, static_cast<off_t>(begin)) != 0) fail(path_, "mend");
    if (::lseek(file_, 0, SEEK_END) < 0) fail(path_, "read");
    if (number == 0) header_ = json{{kMagic, kFormat}, {"settings", settings}}.dump();
}

void Journal::write(const std::string& line) {
    const std::string text = line + '\n';
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = ::write(file_, text.data() + done, text.size() - done);
        if (count < 0 && errno != EINTR) fail(path_, "write");
        if (count > 0) done += static_cast<std::size_t>(count);
    }
}

void Journal::append(const JournalRecord& record) {
    const std::string line = line_of(record);
    if (!header_.empty()) write(header_);
    header_.clear();
    write(line);
}

void Journal::sync() {
    if (::fsync(file_) != 0 && errno != EINVAL) fail(path_, "write");
}

template <class Record>
const Record& JournaledWorld::replay() {
    const auto* record = std::get_if<Record>(&journal_->records()[place_]);
    if (record == nullptr)
        throw InputError(
            journal_->path() + ":" + std::to_string(place_ + 2) +
            ": error: the run does something else here; the journal was made by another program\n");
    past_ = &record->state;
    return *record;
}

void JournaledWorld::advance() {
    ++place_;
    if (!replaying()) world_->resume(*past_, skills_, tasks_);
}

std::vector<GroundAtom> JournaledWorld::next_task() {
    ++tasks_;
    if (replaying()) {
        const JournalTask& task = replay<JournalTask>();
        advance();
        return task.goal;
    }
    past_ = nullptr;
    std::vector<GroundAtom> goal = world_->next_task();
    journal_->append(JournalTask{goal, world_->observe()});
    return goal;
}

void JournaledWorld::execute(const GroundSkill& skill, std::span<const double> parameters) {
    ++skills_;
    if (replaying()) {
        const JournalStep& step = replay<JournalStep>();
        if (step.skill != skill || !std::ranges::equal(step.parameters, parameters))
            throw InputError(
                journal_->path() + ":" + std::to_string(place_ + 2) +
                ": error: the run decides otherwise here; the journal was made by another program\n");
        advance();
        return;
    }
    past_ = nullptr;
    world_->execute(skill, parameters);
    journal_->append(JournalStep{skill, {parameters.begin(), parameters.end()}, world_->observe()});
}

const State& JournaledWorld::observe() {
    return past_ != nullptr ? *past_ : world_->observe();
}

}  // namespace praxis::practice
