#include "practice/loop/journal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <system_error>

#include "parser/diagnostic.hpp"
#include "tests/practice/support/runs.hpp"

namespace praxis::practice {
namespace {

using test::TestFile;

double any_number() {
    return *rc::gen::suchThat(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                                           [](std::uint64_t bits) {
                                               double number = 0;
                                               std::memcpy(&number, &bits, sizeof number);
                                               return number;
                                           }),
                              [](double number) { return std::isfinite(number); });
}

std::vector<double> some_numbers() {
    std::vector<double> numbers;
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) numbers.push_back(any_number());
    return numbers;
}

JournalRecord any_record() {
    const auto objects = *rc::gen::arbitrary<std::vector<std::int32_t>>();
    const auto name = *rc::gen::arbitrary<std::int32_t>();
    if (*rc::gen::arbitrary<bool>()) return JournalStep{{name, objects}, some_numbers(), some_numbers()};
    JournalTask task{{}, some_numbers()};
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) task.goal.push_back({name - i, objects});
    return task;
}

std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

const JournalStep kStep{{1, {2}}, {0.25}, {1, 2.5}};
const JournalTask kTask{{{0, {1, 2}}, {3, {}}}, {0, -0.0}};

void write_two(const std::string& path) {
    Journal journal(path, "the settings");
    journal.append(kTask);
    journal.append(kStep);
    journal.sync();
}

TEST(Journal, IsOpenOnceAtATime) {
    const TestFile file;
    const auto open_again = [&] { return error_of([&] { Journal(file.path(), "the settings"); }); };
    {
        Journal journal(file.path(), "the settings");
        journal.append(kTask);
        EXPECT_EQ(open_again(), file.path() +
                                    ": error: another run of practice is writing this journal; wait until it "
                                    "ends, or give another name\n");
        journal.append(kStep);
    }
    EXPECT_EQ(open_again(), "no error");
    EXPECT_EQ(Journal(file.path(), "the settings").records().size(), 2u) << "nothing was lost or mixed in";
}

/// In another process: opens the journal, says so, and dies with it open when it may.
[[noreturn]] void hold_journal(const std::string& path, int opened, int may_end) {
    try {
        const Journal journal(path, "the settings");
        char byte = 0;
        const bool told = ::write(opened, &byte, 1) == 1 && ::read(may_end, &byte, 1) == 0;
        ::_exit(told ? 0 : 1);
    } catch (...) {
        ::_exit(2);
    }
}

TEST(Journal, IsRefusedWhileAnotherProcessWritesIt) {
    const TestFile file;
    int opened[2] = {}, may_end[2] = {};
    ASSERT_EQ(::pipe(opened), 0);
    ASSERT_EQ(::pipe(may_end), 0);
    const pid_t other = ::fork();
    if (other == 0) {
        ::close(may_end[1]);
        hold_journal(file.path(), opened[1], may_end[0]);
    }
    ::close(opened[1]);
    char byte = 0;
    EXPECT_EQ(::read(opened[0], &byte, 1), 1);
    EXPECT_NE(error_of([&] { Journal(file.path(), "the settings"); }).find("another run"), std::string::npos);
    ::close(may_end[1]);
    int status = -1;
    EXPECT_EQ(::waitpid(other, &status, 0), other);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(error_of([&] { Journal(file.path(), "the settings"); }), "no error");
    ::close(opened[0]);
    ::close(may_end[0]);
}

RC_GTEST_PROP(Journal, reads_what_was_written_bit_by_bit, ()) {
    const TestFile file;
    std::vector<JournalRecord> records;
    for (int opened = 0; opened < 2; ++opened) {
        Journal journal(file.path(), "settings \"of\"\nany text");
        RC_ASSERT(journal.records() == records);
        for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
            records.push_back(any_record());
            journal.append(records.back());
        }
    }
    RC_ASSERT(Journal(file.path(), "settings \"of\"\nany text").records() == records);
}

TEST(Journal, KeepsTheSignOfZero) {
    const TestFile file;
    write_two(file.path());
    const Journal journal(file.path(), "the settings");
    EXPECT_TRUE(std::signbit(std::get<JournalTask>(journal.records()[0]).state[1]));
}

TEST(Journal, DropsATornLastLineWhereverItIsTorn) {
    const TestFile file;
    write_two(file.path());
    const std::string whole = file.text();
    const std::vector<JournalRecord> records = {kTask, kStep};
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        file.write(whole.substr(0, size));
        const auto lines = std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size), '\n');
        const std::size_t kept = lines > 0 ? static_cast<std::size_t>(lines) - 1 : 0;
        Journal journal(file.path(), "the settings");
        ASSERT_EQ(journal.records().size(), kept) << size;
        for (std::size_t i = kept; i < records.size(); ++i) journal.append(records[i]);
        ASSERT_EQ(file.text(), whole) << size;
    }
}

TEST(Journal, RefusesADamagedLineByItsNumber) {
    const TestFile file;
    const std::string whole = [&] {
        write_two(file.path());
        return file.text();
    }();
    const std::size_t second = whole.find('\n') + 1;
    for (const std::string damage : {"", "null", "{\"task\":[[0,1]]}", "{\"task\":[[]],\"state\":[]}",
                                     "{\"skill\":[1],\"parameters\":[]}", "{\"task\":[],\"state\":[null]}",
                                     "{\"task\":[],\"state\":[1e999]}", "{\"task\":[],\"state\":\"0\"}",
                                     "{\"skill\":[\"a\"],\"parameters\":[],\"state\":[]}"}) {
        file.write(whole.substr(0, second) + damage + "\n" + whole.substr(second));
        const std::string error = error_of([&] { Journal(file.path(), "the settings"); });
        EXPECT_NE(error.find(file.path() + ":2: error:"), std::string::npos) << damage << ": " << error;
    }
    EXPECT_EQ(file.text().substr(0, second), whole.substr(0, second));
}

TEST(Journal, RefusesOtherSettingsAndOtherFormats) {
    const TestFile file;
    write_two(file.path());
    const std::string whole = file.text();
    EXPECT_NE(error_of([&] { Journal(file.path(), "others"); }).find("other settings (the settings)"),
              std::string::npos);
    EXPECT_EQ(file.text(), whole);
    file.write("{\"praxis practice journal\":99,\"settings\":\"the settings\"}\n");
    EXPECT_NE(error_of([&] { Journal(file.path(), "the settings"); }).find("version"), std::string::npos);
}

TEST(Journal, LeavesFilesAloneThatAreNoJournals) {
    const TestFile file;
    for (const std::string text :
         {"a note without an end of line", "a note\n", "{}\n", "{\"praxis\"", "\n"}) {
        file.write(text);
        EXPECT_NE(error_of([&] { Journal(file.path(), "the settings"); }).find(":1: error:"),
                  std::string::npos)
            << text;
        EXPECT_EQ(file.text(), text);
    }
}

TEST(Journal, SaysWhatItCannotOpenOrWrite) {
    EXPECT_THROW(Journal("/no/such/folder/journal", ""), std::system_error);
    EXPECT_THROW(Journal(::testing::TempDir(), ""), std::system_error);
    EXPECT_THROW(Journal("/dev/null", ""), InputError);
}

TEST(Journal, SaysThatThereIsNoRoomAndKeepsWhatIsWritten) {
    const TestFile file;
    write_two(file.path());
    const auto previous_handler = ::signal(SIGXFSZ, SIG_IGN);
    rlimit previous{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &previous), 0);
    rlimit tight = previous;
    tight.rlim_cur = file.text().size() + 10;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    EXPECT_THROW(Journal(file.path(), "the settings").append(kStep), std::system_error);
    ::setrlimit(RLIMIT_FSIZE, &previous);
    ::signal(SIGXFSZ, previous_handler);
    EXPECT_EQ(Journal(file.path(), "the settings").records(), (std::vector<JournalRecord>{kTask, kStep}));
}

TEST(Journal, RefusesNumbersThatItCouldNotReadAgain) {
    const TestFile file;
    Journal journal(file.path(), "the settings");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(journal.append(JournalTask{{}, {nan}}), std::invalid_argument);
    EXPECT_THROW(journal.append(JournalStep{{}, {infinity}, {}}), std::invalid_argument);
    EXPECT_THROW(journal.append(JournalStep{{}, {}, {-infinity}}), std::invalid_argument);
    EXPECT_EQ(file.text(), "");
}

}  // namespace
}  // namespace praxis::practice
