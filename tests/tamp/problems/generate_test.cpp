#include "tamp/problems/generate.hpp"

#include <gtest/gtest.h>

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

TEST_P(Families, EverySizeIsSoundAtTheStart) {
    const ProblemFamily& family = GetParam();
    for (int size = family.smallest; size <= family.largest; size += std::max(1, family.largest / 4)) {
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const BoundProblem problem = bound(generate_problem(family.name, size, seed), family.name);
            EXPECT_EQ(text(check_scene(problem.scene)), "") << family.name << ' ' << size << ' ' << seed;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(problem_families()), [](const auto& info) {
    std::string name = info.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(Generate, RefusesWhatItDoesNotHave) {
    EXPECT_THROW(generate_problem("hanoy", 3, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 0, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 1'000, 1), std::invalid_argument);
    EXPECT_THROW(generate_problem("hanoi", 3, 1, false), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
