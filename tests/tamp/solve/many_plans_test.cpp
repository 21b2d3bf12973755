// Hundreds of plans of all kinds, every one checked by the independent validators: `solve` throws
// InvalidSolution for what they refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/tamp/support/generated_problem.hpp"

namespace praxis::tamp {
namespace {

#ifdef PRAXIS_SANITIZED
constexpr int kShare = 10;
constexpr double kSeconds = 60;
#else
constexpr int kShare = 1;
constexpr double kSeconds = 10;
#endif

struct Many {
    const char* family;
    int size;
    int plans;  ///< without sanitizers; all together 500
};

std::string name_of(const Many& many) {
    std::string name = std::string(many.family) + "_" + std::to_string(many.size);
    std::ranges::replace(name, '-', '_');
    return name;
}

class ManyPlans : public testing::TestWithParam<Many> {};

TEST_P(ManyPlans, AreValid) {
    const Many& many = GetParam();
    const std::string folder = testing::TempDir() + "praxis-many-" + name_of(many);
    int solved = 0;
    const int plans = std::max(1, many.plans / kShare);
    for (int i = 0; i < plans; ++i) {
        // Other seeds than those that other tests use.
        const auto seed = static_cast<std::uint64_t>(1000 + i);
        const GeneratedProblem problem = generate_problem(many.family, many.size, seed);
        write_problem(problem, folder);
        SolveOptions options;
        options.refine.seed = seed;
        options.join = i % 4 != 0;
        options.schedule.speed = i % 3 == 0 ? 0.5 : 1;
        try {
            const Solution solution =
                solve(scene_problem(problem, folder), options, Budget().limit_wall_time(kSeconds));
            solved += solution.refinement.plan.has_value() ? 1 : 0;
            EXPECT_EQ(solution.refinement.plan.has_value(), solution.checked > 0) << seed;
        } catch (const InvalidSolution& fault) {
            ADD_FAILURE() << many.family << ' ' << many.size << " seed " << seed << ": " << fault.what();
        }
    }
    std::filesystem::remove_all(folder);
    EXPECT_GE(solved * 20, plans * 19);
}

INSTANTIATE_TEST_SUITE_P(Of, ManyPlans,
                         testing::Values(Many{"clutter", 2, 100}, Many{"clutter", 4, 60},
                                         Many{"hanoi", 2, 80}, Many{"hanoi", 3, 40}, Many{"kitchen", 1, 60},
                                         Many{"kitchen", 2, 30}, Many{"packing", 3, 60},
                                         Many{"blocked-shelf", 1, 25}, Many{"non-monotonic", 1, 15},
                                         Many{"point-cloud-shelf", 1, 5}, Many{"rooms", 6, 20},
                                         Many{"rooms-octomap", 6, 5}),
                         [](const auto& many) { return name_of(many.param); });

}  // namespace
}  // namespace praxis::tamp
