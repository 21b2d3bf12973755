// Plans of `solve`, carried out.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tamp/skills/refined_skills.hpp"
#include "tamp/skills/simulated_driver.hpp"
#include "tamp/solve/solve.hpp"

namespace praxis::tamp {
namespace {

using Status = Execution::Status;

SceneProblem weak_hand() {
    const std::string folder = PRAXIS_SOURCE_DIR "/docs/examples/weak-hand";
    return load_scene_problem(folder + "/domain.pddl", folder + "/problem.pddl", "", folder + "/scene.yaml");
}

/// Only the first can is light.
TrajectoryDocument plan(const SceneProblem& problem, bool join = true) {
    SolveCallbacks callbacks;
    callbacks.bind = [](StreamLibrary& library, const Scene&) {
        library.bind("test-liftable", [](StreamCall& call) {
            return call.inputs[0].name() == "can1" ? StreamResult::pass() : StreamResult::reject({});
        });
    };
    SolveOptions options;
    options.join = join;
    return solve(problem, options, {}, callbacks).document;
}

/// The problem with the bodies where they are seen.
SceneProblem as_it_is(const SceneProblem& problem, const Situation& now) {
    SceneProblem result = problem;
    World world = *problem.scene.world;
    for (const auto& [name, pose] : now.bodies) world = world.with_pose(world.find(name), pose);
    result.scene.world = std::make_shared<const World>(world);
    return result;
}

Vector3 goal(const SceneProblem& problem) {
    const Region& region = problem.scene.regions[0];
    return (surface_pose(problem.scene, region.surface) * region.pose).translation();
}

class SolvedPlan : public testing::TestWithParam<bool> {};

TEST_P(SolvedPlan, IsCarriedOut) {
    const SceneProblem problem = weak_hand();
    const TrajectoryDocument document = plan(problem, GetParam());
    SimulatedDriver driver(document, {.noise = 0.001});
    RefinedSkills skills(planned(document), *problem.scene.robot, driver);
    EXPECT_EQ(skills.execute({{"place", "can1"}}, {}, {}).status, Status::illegal);
    for (const char* name : {"pick", "place"}) {
        const Execution execution = skills.execute({{name, "can1"}}, {}, {});
        EXPECT_EQ(execution.status, Status::done) << execution.message;
    }
    const Vector3 off = driver.bodies().at("can1").translation() - goal(problem);
    EXPECT_LT(off.head<2>().cwiseAbs().maxCoeff(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(JoinedAndByHome, SolvedPlan, testing::Bool());

TEST(SolvedPlans, AreMadeWhenTheyAreCalledFor) {
    const SceneProblem problem = weak_hand();
    const TrajectoryDocument document = plan(problem);
    SimulatedDriver driver(document);
    const Pose before = driver.bodies().at("can1");
    driver.put("can1", Eigen::Translation3d(0.05, 0.1, 0) * before);

    RefinedSkills fixed(planned(document), *problem.scene.robot, driver);
    EXPECT_EQ(fixed.execute({{"pick", "can1", "p1"}}, {}, {}).status, Status::illegal);

    std::vector<RefinedSkill> steps;
    const auto refine = [&](const ActionName& action, std::span<const double>, const Situation& now) {
        if (action.words[0] == "pick") steps = refined_skills(plan(as_it_is(problem, now)));
        return steps;
    };
    RefinedSkills skills(refine, *problem.scene.robot, driver);
    EXPECT_EQ(skills.execute({{"pick", "can1", "p1"}}, {}, {}).status, Status::done);
    EXPECT_TRUE(driver.holds("can1"));
    EXPECT_EQ(skills.execute({{"place", "can1"}}, {}, {}).status, Status::done);
}

}  // namespace
}  // namespace praxis::tamp
