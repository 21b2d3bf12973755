#include "practice/experiment/run_store.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "parser/diagnostic.hpp"
#include "practice/experiment/run_json.hpp"
#include "search/text/output.hpp"
#include "support.hpp"

namespace praxis::practice {
namespace {

namespace fs = std::filesystem;
using testing::example_run;

std::string refusal(const std::string& text) {
    try {
        read_run({"a.b.1.json", text});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// What the reader says to a good file in which one member is another.
std::string refusal_with(const char* pointer, const nlohmann::json& value) {
    auto file = nlohmann::json::parse(run_to_json({example_run("row", "ees", 1), "tasks=100"}));
    file[nlohmann::json::json_pointer(pointer)] = value;
    return refusal(file.dump());
}

TEST(RunJson, ComesBackExactly) {
    StoredRun stored{example_run("row", "ees", std::numeric_limits<std::uint64_t>::max()), "tasks=100"};
    stored.run.processor_seconds = 0.1 + 0.2;
    stored.run.choices[0].candidates[0].cost = std::numeric_limits<double>::infinity();
    EXPECT_EQ(read_run({"f", run_to_json(stored)}), stored);
}

TEST(RunJson, HostileNamesComeBack) {
    for (const std::string& name : testing::hostile_names()) {
        StoredRun stored{example_run(name, name, 1), name};
        stored.run.choices[0].chosen = stored.run.choices[0].candidates[0].skill = name;
        EXPECT_EQ(read_run({"f", run_to_json(stored)}), stored);
    }
}

RC_GTEST_PROP(RunJson, NumbersComeBack, (double a, double b, int tries)) {
    StoredRun stored{example_run("row", "ees", 1), ""};
    CandidateScore& candidate = stored.run.choices[0].candidates[0];
    candidate.score = a;
    candidate.cost = b;
    candidate.tries = tries < 0 ? -(tries + 1) : tries;
    candidate.successes = candidate.tries / 2;
    RC_ASSERT(read_run({"f", run_to_json(stored)}) == stored);
}

TEST(RunJson, RefusesToWriteWhatItWouldNotRead) {
    const RunResult good = example_run("row", "ees", 1);
    const auto refuses = [&](auto change) {
        RunResult run = good;
        change(run);
        EXPECT_THROW(run_to_json({run, ""}), std::invalid_argument);
    };
    refuses([](RunResult& run) { run.curve.clear(); });
    refuses([](RunResult& run) { run.curve[1].solved = 2; });
    refuses([](RunResult& run) { run.processor_seconds = std::numeric_limits<double>::infinity(); });
    refuses([](RunResult& run) { run.choices[0].candidates[0].score = std::nan(""); });
    refuses([](RunResult& run) { run.choices[0].candidates[0].successes = 1000; });
    refuses([](RunResult& run) { run.choices[0].cycle = -1; });
    refuses([](RunResult& run) { run.method = "\xff"; });
    EXPECT_THROW(run_to_json({good, "\xc3("}), std::invalid_argument);
}

TEST(RunJson, RefusalsNameThePlace) {
    const auto expect = [](const char* pointer, const nlohmann::json& value, const std::string& part) {
        const std::string message = refusal_with(pointer, value);
        EXPECT_NE(message.find("a.b.1.json"), std::string::npos) << pointer;
        EXPECT_NE(message.find(part), std::string::npos) << pointer << "\n" << message;
        EXPECT_NE(message.find("remove the file"), std::string::npos) << message;
    };
    EXPECT_EQ(refusal_with("/more", 1), "");
    expect("/format", "other", "format must be \"praxis-practice-run\"");
    expect("/version", 2, "version must be 1");
    expect("/fingerprint", 5, "fingerprint must be a text");
    expect("/environment", nullptr, "environment must be a text");
    expect("/seed", -1, "seed must be a whole number");
    expect("/seed", 1.5, "seed must be a whole number");
    expect("/processor_seconds", "fast", "processor_seconds must be a number");
    expect("/curve", "none", "curve must be a list");
    expect("/curve", nlohmann::json::array(), "has no evaluation");
    expect("/curve/2", 7, "curve[2] must be a list");
    expect("/curve/2/2", 1.5, "fractions outside of 0 to 1");
    expect("/curve/2/0", 99999999999, "curve[2][0] must be a whole number from 0 to 2147483647");
    expect("/curve/2/0", 0, "has cycles that fall");
    expect("/skills/0", 1, "skills[0] must be a text");
    expect("/skills", nlohmann::json::array(), "which is empty");
    expect("/choices/0", 1, "choices[0] must be an object");
    expect("/choices/0/cycle", "one", "choices[0].cycle must be a whole number");
    expect("/choices/1/candidates/0/0", 3, "choices[1].candidates[0][0] must be a whole number from 0 to 2");
    expect("/choices/1/candidates/0/1", "nan", "must be a number, \"inf\" or \"-inf\"");
    expect("/choices/1/candidates/0/6", 50, "choices[1].candidates[0][6] must be");
}

TEST(RunJson, DamagedFilesAreRefused) {
    const std::string good = run_to_json({example_run("row", "ees", 1), "tasks=100"});
    EXPECT_EQ(refusal(good), "");
    for (std::size_t length = 0; length + 2 < good.size(); length += 7)
        EXPECT_NE(refusal(good.substr(0, length)), "") << length;
    EXPECT_NE(refusal("\n\n{\"format\": oops}").find("a.b.1.json:3:"), std::string::npos);
    EXPECT_NE(refusal("[]").find("the file must be an object"), std::string::npos);
    EXPECT_NE(refusal("{}").find("format is missing"), std::string::npos);
    EXPECT_NE(refusal("{\"seed\": 1e999}").find("too large"), std::string::npos);
    EXPECT_NE(refusal(std::string(100'000, '[')), "");
    EXPECT_NE(refusal(std::string(100'000, '[') + std::string(100'000, ']')), "");
}

RC_GTEST_PROP(RunJson, ChangedBytesAreReadOrRefused, ()) {
    std::string text = run_to_json({example_run("row", "ees", 1, 2, 2), "tasks=100"});
    const int changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i)
        text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
    try {
        run_to_json(read_run({"f", text}));
    } catch (const InputError&) {
    }
}

class RunStoreTest : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "praxis-runs-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }
    RunStore store(const std::string& fingerprint = "tasks=100") const {
        return {(folder_ / "a" / "results").string(), fingerprint};
    }
    static std::string refusal(const RunStore& store, const RunKey& key) {
        try {
            store.load(key);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_;
};

TEST_F(RunStoreTest, KeepsFinishedRuns) {
    const RunStore first = store();
    const RunResult run = example_run("ball-ring", "ees", 456);
    const RunKey key{"ball-ring", "ees", 456};
    EXPECT_FALSE(first.contains(key));
    first.save(run);
    EXPECT_TRUE(first.contains(key));
    EXPECT_EQ(fs::path(first.path(key)).filename(), "ball-ring.ees.456.json");
    const RunStore again = store();
    EXPECT_EQ(again.finished(), (std::vector<RunKey>{key}));
    EXPECT_EQ(again.load(key), run);
    EXPECT_EQ(again.load_all(), (std::vector<RunResult>{run}));
}

TEST_F(RunStoreTest, ReplacesARunAndLeavesNothingElse) {
    const RunStore runs = store();
    RunResult run = example_run("row", "ees", 1);
    runs.save(run);
    run.curve.back().solved = 0.5;
    runs.save(run);
    EXPECT_EQ(runs.load({"row", "ees", 1}), run);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "a" / "results"), fs::directory_iterator()), 1);
}

TEST_F(RunStoreTest, HostileNamesHaveFilesOfTheirOwn) {
    const RunStore runs = store();
    std::vector<RunKey> keys;
    for (const std::string& environment : testing::hostile_names())
        for (const std::string& method : {std::string("ees(window=2)"), testing::hostile_names()[6]}) {
            keys.push_back({environment, method, 1});
            runs.save(example_run(environment, method, 1, 1, 1));
        }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(runs.finished(), keys);
    EXPECT_EQ(runs.load_all().size(), keys.size());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(RunStoreTest, PassesOverOtherFiles) {
    const RunStore runs = store();
    runs.save(example_run("row", "ees", 1));
    const fs::path folder = folder_ / "a" / "results";
    for (const char* name :
         {"curves.csv", "a.b.json", "row.ees.01.json", "row.ees.x.json", "row.ees.2.json.part77",
          "row.ee%73.3.json", "row.%.3.json", "row.ees.-1.json", "r.e.e.1.json", ".json"})
        std::ofstream(folder / name) << "{}";
    fs::create_directory(folder / "row.ees.5.json");
    EXPECT_EQ(runs.finished(), (std::vector<RunKey>{{"row", "ees", 1}}));
}

TEST_F(RunStoreTest, RunsWithOtherSettingsDoNotMix) {
    store().save(example_run("row", "ees", 1));
    const std::string message = refusal(store("tasks=10"), {"row", "ees", 1});
    for (const char* part :
         {"row.ees.1.json", "other settings", "tasks=100", "tasks=10\n", "another directory"})
        EXPECT_NE(message.find(part), std::string::npos) << part;
}

TEST_F(RunStoreTest, RefusesFilesOfOtherRuns) {
    const RunStore runs = store();
    runs.save(example_run("row", "ees", 1));
    fs::rename(runs.path({"row", "ees", 1}), runs.path({"row", "ees", 2}));
    EXPECT_NE(refusal(runs, {"row", "ees", 2}).find("another run"), std::string::npos);
    EXPECT_NE(refusal(runs, {"row", "ees", 1}).find("cannot be opened"), std::string::npos);
}

TEST_F(RunStoreTest, RefusesAPlaceThatIsNoDirectory) {
    std::ofstream(folder_ / "file") << "text";
    EXPECT_THROW(RunStore((folder_ / "file").string(), ""), OutputError);
    EXPECT_THROW(RunStore((folder_ / "file" / "below").string(), ""), OutputError);
    const RunStore gone = store();
    fs::remove_all(folder_ / "a");
    EXPECT_THROW(gone.finished(), InputError);
    EXPECT_THROW(gone.save(example_run("row", "ees", 1)), OutputError);
}

TEST_F(RunStoreTest, NamesThatNoFileSystemHoldsAreRefused) {
    EXPECT_THROW(store().save(example_run(std::string(300, 'a'), "ees", 1)), OutputError);
}

}  // namespace
}  // namespace praxis::practice
