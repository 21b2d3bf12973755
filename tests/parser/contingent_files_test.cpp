// Every file of a folder of contingent benchmarks can be read, and tasks that are written read back as the
// same. The folder (K-replanner's `benchmarks/replanner`, say) is named by PRAXIS_CONTINGENT_BENCHMARKS.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "tests/parser/contingent_texts.hpp"

namespace praxis {
namespace {

namespace fs = std::filesystem;

/// Files of K-replanner's benchmarks that are wrong in themselves.
constexpr const char* kWrong[] = {
    "minesweeper/ms-05/p.pddl",                      // a parenthesis is missing
    "rocksample/multivalued-variables/p08-08.pddl",  // a predicate is misspelled
    "rocksample/multivalued-variables/p08-12.pddl",
    "rocksample/multivalued-variables/p08-14.pddl",
    "multivalued-variables/diag15/d.pddl",  // objects declared twice, others not at all
};

bool is_wrong(const fs::path& file) {
    return std::any_of(std::begin(kWrong), std::end(kWrong),
                       [&](const char* end) { return file.string().ends_with(end); });
}

/// The files of one folder by what they are.
struct Folder {
    std::vector<fs::path> domains;
    std::vector<fs::path> problems;
    std::vector<fs::path> worlds;
};

std::map<fs::path, Folder> folders_below(const fs::path& root) {
    std::map<fs::path, Folder> folders;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".pddl") && !name.starts_with("pfile")) continue;
        std::ifstream in(entry.path());
        std::stringstream text;
        for (std::string line; std::getline(in, line);) text << line.substr(0, line.find(';')) << '\n';
        const std::string content = text.str();
        Folder& folder = folders[entry.path().parent_path()];
        if (content.find("(domain ") < content.find("(problem ")) {
            folder.domains.push_back(entry.path());
        } else if (content.find(":goal") != std::string::npos) {
            folder.problems.push_back(entry.path());
        } else {
            folder.worlds.push_back(entry.path());
        }
    }
    return folders;
}

std::shared_ptr<const ContingentTask> read(const fs::path& domain, const fs::path& problem,
                                           const std::vector<std::string>& worlds) {
    try {
        return load_contingent(domain.string(), problem.string(), worlds).task;
    } catch (const InputError&) {
        return nullptr;
    }
}

void expect_round_trip(const ContingentTask& task, const fs::path& file) {
    const auto again = test::parse_belief(write_contingent_domain(task), write_contingent_problem(task)).task;
    EXPECT_TRUE(test::dump(task) == test::dump(*again)) << file;
}

TEST(ContingentFiles, AreReadAndWritten) {
    const char* const root = std::getenv("PRAXIS_CONTINGENT_BENCHMARKS");
    if (root == nullptr) GTEST_SKIP() << "PRAXIS_CONTINGENT_BENCHMARKS names no folder";
    const std::map<fs::path, Folder> folders = folders_below(root);
    std::set<fs::path> wanted;
    std::set<fs::path> understood;
    for (const auto& [path, folder] : folders) {
        wanted.insert(folder.domains.begin(), folder.domains.end());
        wanted.insert(folder.problems.begin(), folder.problems.end());
        wanted.insert(folder.worlds.begin(), folder.worlds.end());
        std::vector<fs::path> domains = folder.domains;
        const auto above = folders.find(path.parent_path());
        if (domains.empty() && above != folders.end()) domains = above->second.domains;
        for (const fs::path& domain : domains) {
            for (const fs::path& problem : folder.problems) {
                const auto task = read(domain, problem, {});
                if (!task) continue;
                understood.insert({domain, problem});
                expect_round_trip(*task, problem);
                for (const fs::path& world : folder.worlds) {
                    if (understood.contains(world)) continue;
                    const auto with_world = read(domain, problem, {world.string()});
                    if (!with_world) continue;
                    understood.insert(world);
                    expect_round_trip(*with_world, world);
                }
            }
        }
    }
    // What stands beside a wrong file, and domains without a problem, are read with a problem of our own.
    std::size_t wrong = 0;
    for (const fs::path& file : wanted) {
        if (understood.contains(file)) continue;
        if (is_wrong(file)) {
            ++wrong;
            continue;
        }
        const bool beside_wrong = std::any_of(wanted.begin(), wanted.end(), [&](const fs::path& other) {
            return is_wrong(other) && other.parent_path() == file.parent_path();
        });
        std::ifstream in(file);
        std::stringstream text;
        text << in.rdbuf();
        const std::string error =
            test::belief_error(text.str(), "(define (problem p) (:domain d) (:goal (and)))");
        EXPECT_TRUE(beside_wrong || error.empty()) << file << '\n' << error;
    }
    std::cout << wanted.size() << " files, " << understood.size() << " read in a task, " << wrong
              << " wrong in themselves\n";
    EXPECT_GT(understood.size(), 0U);
}

}  // namespace
}  // namespace praxis
