// Plan files: whole or not at all, numbered where there are several.
#include "app/output.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

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

TEST(WriteFile, ReplacesOnlyWholeFiles) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "old and longer than the new one");
    app::write_file(file, "new");
    EXPECT_EQ(read_file(file), "new");
    EXPECT_EQ(folder.names(), (Names{"file"}));
    EXPECT_THROW(app::write_file(folder / "missing/file", "text"), app::OutputError);
    ASSERT_EQ(::mkdir((folder / "folder").c_str(), 0755), 0);
    EXPECT_THROW(app::write_file(folder / "folder", "text"), app::OutputError);
    EXPECT_EQ(folder.names(), (Names{"file", "folder"}));
}

TEST(WriteFile, SaysWhatIsTheSameFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "");
    EXPECT_TRUE(app::same_file(file, folder / "./file"));
    EXPECT_FALSE(app::same_file(file, folder.write("other", "")));
    EXPECT_FALSE(app::same_file(file, folder / "missing"));
}

}  // namespace
}  // namespace praxis::test
