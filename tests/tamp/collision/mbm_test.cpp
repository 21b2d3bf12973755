// MotionBenchMaker's problems for the Panda: all can be read, and the exact checker agrees with what was
// published of them.
#include <gtest/gtest.h>

#include <filesystem>

#include "parser/files.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/robots/urdf.hpp"
#include "tamp/scenes/moveit.hpp"

namespace praxis::tamp {
namespace {

namespace fs = std::filesystem;

TEST(MotionBenchMaker, StartsAndGoalsAreFreeInAllButOneProblem) {
    const fs::path folder = fs::path(PRAXIS_SOURCE_DIR) / "../shared/data/mbm_panda";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const auto robot = std::make_shared<const Robot>(read_urdf(folder / "panda_spheres.urdf"));
    int problems = 0;
    int valid = 0;
    for (const fs::directory_entry& set : fs::directory_iterator(folder)) {
        if (!set.is_directory()) continue;
        for (int i = 1; i <= 100; ++i) {
            const std::string digits = std::to_string(i);
            const std::string number = std::string(4 - digits.size(), '0') + digits + ".yaml";
            const MoveItProblem problem =
                read_moveit_problem(robot, read_source(set.path() / ("scene" + number)),
                                    read_source(set.path() / ("request" + number)));
            ++problems;
            const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
            ASSERT_EQ(group.variables.size(), 7U);
            ASSERT_EQ(problem.goals.size(), 1U);
            const auto checker =
                make_fcl_checker({problem.robot, problem.world, problem.group, problem.start});
            valid += checker->is_free(problem.robot->extract(group, problem.start)) &&
                             checker->is_free(problem.goals[0])
                         ? 1
                         : 0;
        }
    }
    EXPECT_EQ(problems, 700);
    EXPECT_EQ(valid, 699);
}

}  // namespace
}  // namespace praxis::tamp
