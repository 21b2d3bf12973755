#include "tamp/problems/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tests/tamp/support/bound_problem.hpp"

namespace praxis::tamp {
namespace {

class Families : public testing::TestWithParam<ProblemFamily> {};

/// A folder for the files of a problem, gone at the end.
struct Folder {
    std::string path;
    explicit Folder(const std::string& name) : path(testing::TempDir() + "praxis-" + name) {}
    ~Folder() { std::filesystem::remove_all(path); }
};

BoundProblem bound(const GeneratedProblem& problem, const std::string& name) {
    const Folder folder(name);
    write_problem(problem, folder.path);
    return BoundProblem(problem, folder.path);
}

std::string text(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
}

TEST_P(Families, EqualSeedsGiveEqualProblems) {
    const ProblemFamily& family = GetParam();
    const GeneratedProblem first = generate_problem(family.name, family.smallest, 7);
    const GeneratedProblem again = generate_problem(family.name, family.smallest, 7);
    const GeneratedProblem other = generate_problem(family.name, family.smallest, 8);
    EXPECT_EQ(first.problem, again.problem);
    EXPECT_EQ(first.scene, again.scene);
    EXPECT_EQ(first.files, again.files);
    EXPECT_NE(first.scene, other.scene);
}

TEST_P(Families, EverySizeOfManySeedsFits) {
    const ProblemFamily& family = GetParam();
    for (int size = family.smallest; size <= family.largest; size += std::max(1, family.largest / 10)) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            EXPECT_NO_THROW(generate_problem(family.name, size, seed)) << size << ' ' << seed;
        }
    }
}

TEST_P(Families, EverySizeIsSoundAtTheStart) {
    const ProblemFamily& family = GetParam();
    for (int size = family.smallest; size <= family.largest; size += std::max(1, family.largest / 4)) {
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const BoundProblem problem = bound(generate_problem(family.name, size, seed), family.name);
            EXPECT_EQ(text(check_scene(problem.scene)), "") << family.name << ' ' << size << ' ' << seed;
        }
    }
}

/// Every stream makes something at once.
StreamLibrary believing(const StreamTask& task) {
    StreamLibrary library;
    for (const StreamSchema& stream : task.streams) {
        library.bind(stream.name, [outputs = stream.output_count()](StreamCall&) {
            return StreamResult::sample(std::vector<Value>(outputs, Value::of(0)));
        });
    }
    return library;
}

TEST_P(Families, TheTaskIsSolvableIfAllStreamsAreBelieved) {
    const ProblemFamily& family = GetParam();
    for (const int size : {family.smallest, family.largest}) {
        const BoundProblem problem = bound(generate_problem(family.name, size, 3), family.name);
        const StreamLibrary library = believing(problem.task);
        const Refinement found =
            refine({.task = &problem.task, .library = &library, .values = {}, .options = {}});
        EXPECT_EQ(found.status, RefineStatus::solved) << family.name << ' ' << size;
    }
}

TEST_P(Families, TheSmallestSizeIsSolved) {
    const ProblemFamily& family = GetParam();
#ifdef PRAXIS_SANITIZED
    if (family.name == "namo") GTEST_SKIP() << "takes long with sanitizers";
#endif
    const BoundProblem problem = bound(generate_problem(family.name, family.smallest, 1), family.name);
    const Refinement found = problem.refine(Budget().limit_wall_time(20));
    ASSERT_EQ(found.status, RefineStatus::solved) << text(found.reasons);
    EXPECT_GE(found.plan->steps.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(problem_families()), [](const auto& family) {
    std::string name = family.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
});

/// problems/tamp/FAMILY/SIZE and FAMILY/SIZE-infeasible are what seed 1 gives.
TEST(Generate, ExamplesAreWhatTheGeneratorMakes) {
    namespace fs = std::filesystem;
    const fs::path examples = fs::path(PRAXIS_SOURCE_DIR) / "problems/tamp";
    int count = 0;
    for (const ProblemFamily& family : problem_families()) {
        if (!fs::exists(examples / family.name)) continue;
        for (const fs::directory_entry& folder : fs::directory_iterator(examples / family.name)) {
            const std::string name = folder.path().filename().string();
            const GeneratedProblem made =
                generate_problem(family.name, std::stoi(name), 1, !name.ends_with("-infeasible"));
            EXPECT_EQ(read_source((folder.path() / "problem.pddl").string()).text, made.problem) << folder;
            EXPECT_EQ(read_source((folder.path() / "scene.yaml").string()).text, made.scene) << folder;
            ++count;
        }
    }
    EXPECT_GE(count, 10);
}

TEST(Generate, TwinsAreNeverSolved) {
    int twins = 0;
    for (const ProblemFamily& family : problem_families()) {
        for (std::uint64_t seed = 1; family.has_twin && seed <= 4; ++seed, ++twins) {
            const BoundProblem problem =
                bound(generate_problem(family.name, family.smallest, seed, false), family.name);
            EXPECT_EQ(text(check_scene(problem.scene)), "") << family.name << ' ' << seed;
            const Refinement found = problem.refine(Budget().limit_wall_time(0.2));
            EXPECT_NE(found.status, RefineStatus::solved) << family.name << ' ' << seed;
        }
    }
    EXPECT_GE(twins, 12);
}

TEST(Generate, RefusesWhatItDoesNotHave) {
    EXPECT_THROW(generate_problem("hanoy", 3, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 0, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 1'000, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 3, 1, false), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
