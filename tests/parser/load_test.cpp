// Files: reading them, and finding the domain of a problem.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/parser/texts.hpp"

namespace praxis {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
  protected:
    Files() : folder_(fs::path(testing::TempDir()) / ("praxis_" + std::string(name()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "sub");
    }
    ~Files() override { fs::remove_all(folder_); }

    static const char* name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }

    std::string write(const std::string& file, const std::string& text) const {
        std::ofstream(folder_ / file, std::ios::binary) << text;
        return (folder_ / file).string();
    }
    std::string path(const std::string& file) const { return (folder_ / file).string(); }

    static std::string load_error(const std::string& domain, const std::string& problem) {
        try {
            load(domain, problem);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

  private:
    fs::path folder_;
};

TEST_F(Files, AreLoaded) {
    const std::string domain = write("domain.pddl", test::domain("(:predicates (p))"));
    const std::string problem = write("p01.pddl", test::empty_problem());
    const LoadResult result = load_with_warnings(domain, problem);
    EXPECT_EQ(result.task->predicates.size(), 1U);
    EXPECT_EQ(result.task->sources->files[0].name, domain);
    EXPECT_EQ(load(domain, problem)->domain_name, "d");
}

TEST_F(Files, LargerThanABufferAreReadWholly) {
    std::string objects;
    for (int i = 0; i < 50000; ++i) objects += " object" + std::to_string(i);
    const std::string domain = write("domain.pddl", test::domain(""));
    const std::string problem = write("p.pddl", test::problem("(:objects" + objects + ") (:goal ())"));
    EXPECT_EQ(load(domain, problem)->objects.size(), 50000U);
}

TEST_F(Files, ThatCannotBeReadAreNamed) {
    const std::string domain = write("domain.pddl", test::domain(""));
    EXPECT_EQ(load_error(domain, path("none.pddl")),
              "error: " + path("none.pddl") + ": cannot be opened (No such file or directory)\n");
    EXPECT_EQ(load_error(path("sub"), domain), "error: " + path("sub") + ": is a directory, not a file\n");
    EXPECT_EQ(load_error(write("empty.pddl", ""), domain), "error: " + path("empty.pddl") + ": is empty\n");
    EXPECT_EQ(load_error("-", "-"),
              "error: the domain and the problem cannot both come from standard input\n");
}

TEST_F(Files, DomainsAreFoundBesideProblems) {
    EXPECT_THROW(find_domain_file(path("sub/p01-easy.pddl")), InputError);
    EXPECT_THROW(find_domain_file("-"), InputError);
    const std::string up = write("domain.pddl", "");
    EXPECT_TRUE(fs::equivalent(find_domain_file(path("sub/p01-easy.pddl")), up));
    for (const char* candidate : {"domain01.pddl", "domain-p01-easy.pddl", "domain_p01-easy.pddl",
                                  "p01-domain.pddl", "p01-easy-domain.pddl", "domain.pddl"}) {
        const std::string domain = write(std::string("sub/") + candidate, "");
        EXPECT_EQ(find_domain_file(path("sub/p01-easy.pddl")), domain);
    }
    const std::string sibling = write("nurse-domain.pddl", "");
    fs::remove(up);
    EXPECT_EQ(find_domain_file(path("nurse-problem.pddl")), sibling);
}

}  // namespace
}  // namespace praxis
