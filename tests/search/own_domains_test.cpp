// The domains of domains/ with a plan for each problem: valid as they stand, and broken in every place as the
// textbook semantics says.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "parser/parser.hpp"
#include "search/validate.hpp"
#include "tests/search/support/naive_validator.hpp"

namespace praxis {
namespace {

const std::filesystem::path kRoot = PRAXIS_SOURCE_DIR;

std::vector<std::string> domain_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / "domains")) {
        if (std::filesystem::exists(entry.path() / "domain.pddl")) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Source read(const std::filesystem::path& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {path.string(), {std::istreambuf_iterator<char>(file), {}}};
}

class OwnDomain : public testing::TestWithParam<std::string> {
  protected:
    Task task(const std::string& size) const {
        LoadResult result = load_with_warnings((kRoot / "domains" / GetParam() / "domain.pddl").string(),
                                               (kRoot / "problems" / GetParam() / (size + ".pddl")).string());
        for (const Diagnostic& warning : result.warnings)
            ADD_FAILURE() << to_string(warning, *result.task->sources);
        return result.task;
    }
    Plan plan(const std::string& size, const LiftedTask& task) const {
        return parse_plan(read(kRoot / "tests/data/plans" / (GetParam() + "-" + size + ".plan")), task).plan;
    }
};

TEST_P(OwnDomain, EveryProblemHasAValidPlan) {
    for (const char* size : {"small", "medium", "large"}) {
        const Task loaded = task(size);
        const Plan known = plan(size, *loaded);
        const Verdict verdict = validate(*loaded, known);
        EXPECT_TRUE(verdict.valid) << size << ": " << verdict.reason;
        EXPECT_FALSE(validate(*loaded, {}).valid) << size << ": nothing to do";
    }
}

TEST_P(OwnDomain, BrokenPlansFailWhereTheTextbookSays) {
    const Task loaded = task("small");
    const Plan known = plan("small", *loaded);
    std::size_t invalid = 0;
    const auto check = [&](const Plan& broken) {
        const Verdict verdict = validate(*loaded, broken);
        EXPECT_EQ(verdict.step, test::naive_failure(*loaded, broken)) << verdict.reason;
        invalid += verdict.valid ? 0 : 1;
    };
    for (std::size_t i = 0; i < known.steps.size(); ++i) {
        Plan dropped = known;
        dropped.steps.erase(dropped.steps.begin() + static_cast<std::ptrdiff_t>(i));
        check(dropped);
        Plan doubled = known;
        doubled.steps.insert(doubled.steps.begin() + static_cast<std::ptrdiff_t>(i), known.steps[i]);
        check(doubled);
        for (std::size_t j = i + 1; j < known.steps.size(); ++j) {
            Plan swapped = known;
            std::swap(swapped.steps[i], swapped.steps[j]);
            check(swapped);
        }
    }
    EXPECT_GT(invalid, 0U);
}

INSTANTIATE_TEST_SUITE_P(Domains, OwnDomain, testing::ValuesIn(domain_names()), [](const auto& domain) {
    std::string name = domain.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace praxis
