// All tasks of the IPC suites load, where the suites are at hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "parser/parser.hpp"

namespace praxis {
namespace {

const std::string kBench = PRAXIS_SOURCE_DIR "/../shared/bench/";

class Suite : public testing::TestWithParam<const char*> {};

TEST_P(Suite, LoadsWholly) {
    std::ifstream list(kBench + GetParam());
    if (!list) GTEST_SKIP() << "no IPC tasks at " << kBench;
    std::size_t tasks = 0;
    std::string name;
    std::string domain;
    std::string problem;
    while (list >> name >> domain >> problem) {
        ++tasks;
        try {
            const Task task = load(kBench + domain, kBench + problem);
            EXPECT_FALSE(task->schemas.empty()) << name;
            std::size_t atoms = 0;
            for (const Relation& relation : task->initial_atoms) {
                EXPECT_EQ(relation.arguments.size(), relation.count * relation.arity) << name;
                atoms += relation.count;
            }
            EXPECT_GT(atoms, 0U) << name;
        } catch (const InputError& error) {
            ADD_FAILURE() << name << '\n' << error.what();
        }
    }
    EXPECT_GE(tasks, 90U);
}

INSTANTIATE_TEST_SUITE_P(Ipc, Suite, testing::Values("smoke.txt", "sat.txt", "opt.txt"),
                         [](const auto& suite) { return std::string(suite.param).substr(0, 3) + "_list"; });

TEST(Ipc, DomainsAreFoundBesideTheirProblems) {
    std::ifstream list(kBench + "smoke.txt");
    if (!list) GTEST_SKIP() << "no IPC tasks at " << kBench;
    std::string name;
    std::string domain;
    std::string problem;
    while (list >> name >> domain >> problem) {
        EXPECT_TRUE(std::filesystem::equivalent(find_domain_file(kBench + problem), kBench + domain)) << name;
    }
}

}  // namespace
}  // namespace praxis
