// Plan files: whole or not at all, numbered where there are several.
#include "app/output.hpp"

#include <gtest/gtest.h>

#include "tests/app/process.hpp"

namespace praxis::test {
namespace {

using Names = std::vector<std::string>;

TEST(PlanFiles, OnePlanIsOneFile) {
    const TemporaryFolder folder;
    app::PlanFiles files(folder / "plan");
    files.write("first");
    EXPECT_EQ(folder.names(), (Names{"plan"}));
    EXPECT_EQ(read_file(folder / "plan"), "first");
}

TEST(PlanFiles, BetterPlansAreNumbered) {
    const TemporaryFolder folder;
    app::PlanFiles files(folder / "plan");
    files.write("first");
    files.write("second");
    files.write("third");
    EXPECT_EQ(folder.names(), (Names{"plan", "plan.1", "plan.2", "plan.3"}));
    EXPECT_EQ(read_file(folder / "plan"), "third");
    EXPECT_EQ(read_file(folder / "plan.1"), "first");
    EXPECT_EQ(read_file(folder / "plan.2"), "second");
    EXPECT_EQ(read_file(folder / "plan.3"), "third");
}

TEST(PlanFiles, OldOnesGoFirst) {
    const TemporaryFolder folder;
    for (const char* name : {"plan", "plan.1", "plan.2", "plan.9", "other"}) folder.write(name, "old");
    const app::PlanFiles files(folder / "plan");
    EXPECT_EQ(folder.names(), (Names{"other", "plan.9"}));
}

TEST(PlanFiles, NoNameNoFile) {
    app::PlanFiles files("");
    EXPECT_NO_THROW(files.write("text"));
}

TEST(SameFile, KnowsAFileByAnyOfItsNames) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "");
    EXPECT_TRUE(app::same_file(file, folder / "./file"));
    EXPECT_FALSE(app::same_file(file, folder.write("other", "")));
    EXPECT_FALSE(app::same_file(file, folder / "missing"));
}

}  // namespace
}  // namespace praxis::test
