#include "search/text/output.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace praxis {
namespace {

namespace fs = std::filesystem;

class Output : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "praxis-output-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }
    static std::string content(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    fs::path folder_;
};

TEST_F(Output, ReplacesTheWholeFileAndLeavesNothingElse) {
    const fs::path path = folder_ / "result";
    write_file(path.string(), std::string(100'000, 'x'));
    write_file(path.string(), std::string("a\0b", 3));
    EXPECT_EQ(content(path), std::string("a\0b", 3));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Output, ReadersThatHaveTheOldFileOpenStillSeeAllOfIt) {
    const fs::path path = folder_ / "result";
    write_file(path.string(), "old");
    std::ifstream reader(path);
    write_file(path.string(), "new and longer");
    std::ostringstream seen;
    seen << reader.rdbuf();
    EXPECT_EQ(seen.str(), "old");
    EXPECT_EQ(content(path), "new and longer");
}

TEST_F(Output, NamesTheFileThatCannotBeWritten) {
    const std::string path = (folder_ / "missing" / "result").string();
    try {
        write_file(path, "text");
        FAIL() << "written";
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
}

TEST_F(Output, ADirectoryIsNotReplacedAndNothingIsLeftBesideIt) {
    const fs::path inner = folder_ / "inner";
    fs::create_directory(inner);
    EXPECT_THROW(write_file(inner.string(), "text"), OutputError);
    EXPECT_TRUE(fs::is_directory(inner));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace praxis
