#include "tamp/motion/planner.hpp"

#include <gtest/gtest.h>

#include "tamp/collision/fast_checker.hpp"
#include "tamp/motion/certify.hpp"
#include "tamp/motion/shortcut.hpp"
#include "tests/tamp/support/ball_arm.hpp"

namespace praxis::tamp {
namespace {

/// A disc of 0.2 m that slides in the square of 3 m around the origin.
std::shared_ptr<const Robot> disc() {
    Robot robot;
    robot.name = "disc";
    robot.links = {
        {.name = "root"}, {.name = "rail", .parent_joint = 0}, {.name = "disc", .parent_joint = 1}};
    robot.links[2].collision = {{Pose::Identity(), Sphere{0.2}}};
    robot.links[2].balls = {{Vector3::Zero(), 0.2}};
    for (int i = 0; i < 2; ++i) {
        robot.joints.push_back({.name = i == 0 ? "x" : "y",
                                .type = JointType::prismatic,
                                .parent = i,
                                .child = i + 1,
                                .axis = i == 0 ? Vector3::UnitX() : Vector3::UnitY(),
                                .variable = i});
        robot.variables.push_back({.name = i == 0 ? "x" : "y", .lower = -1.5, .upper = 1.5});
    }
    robot.groups = {{.name = "base", .variables = {0, 1}, .tip = 2}};
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

World with_box(const World& world, const std::string& name, double x, double y, const Vector3& size) {
    BodyModel model;
    model.name = name;
    model.shapes.push_back({Pose::Identity(), Box{size}});
    return world.with_body(std::make_shared<const BodyModel>(std::move(model)),
                           pose_from_rpy({x, y, 0}, Vector3::Zero()));
}

/// A wall along y at x = 0, with a gap of the given width in the middle.
World wall(double gap) {
    const double length = 2 - gap / 2;
    const World lower = with_box(World(), "lower", 0, -gap / 2 - length / 2, {0.1, length, 1});
    return with_box(lower, "upper", 0, gap / 2 + length / 2, {0.1, length, 1});
}

std::unique_ptr<CollisionChecker> disc_checker(const World& world) {
    return make_fast_checker({disc(), std::make_shared<const World>(world), 0, {0, 0}});
}

const std::vector<Configuration> kRight = {{1, 0.7}};
const Configuration kLeft = {-1, 0.7};

TEST(Planner, ADiscGoesThroughAGap) {
    const auto checker = disc_checker(wall(0.5));
    const MotionResult result = plan_motion(*checker, kLeft, kRight);
    ASSERT_EQ(result.status, MotionStatus::solved);
    EXPECT_EQ(result.goal, 0);
    EXPECT_EQ(result.path.front(), kLeft);
    EXPECT_EQ(result.path.back(), kRight[0]);
    EXPECT_LT(path_length(result.path), 3);
    for (std::size_t i = 0; i + 1 < result.path.size(); ++i) {
        EXPECT_TRUE(checker->is_motion_free(result.path[i], result.path[i + 1], 1.0 / 2000));
    }
}

TEST(Planner, AGapThatIsTooNarrowIsBlamedOnTheWall) {
    const auto checker = disc_checker(with_box(wall(0.39), "aside", 1.3, -1.3, {0.1, 0.1, 1}));
    MotionOptions options;
    options.max_iterations = 3000;
    const MotionResult result = plan_motion(*checker, kLeft, kRight, options);
    EXPECT_EQ(result.status, MotionStatus::not_found);
    EXPECT_TRUE(result.path.empty());
    EXPECT_EQ(result.goal, -1);
    EXPECT_EQ(result.iterations, 3000);
    ASSERT_GE(result.obstructions.size(), 2U);
    const World& world = *checker->problem().world;
    for (std::size_t i = 0; i < 2; ++i) {
        const Obstruction& obstruction = result.obstructions[i];
        EXPECT_EQ(obstruction.who.kind, Participant::Kind::body);
        EXPECT_NE(world[obstruction.who.index].model->name, "aside");
        EXPECT_GT(obstruction.count, 0);
    }
}

TEST(Planner, EndsThatCannotBeAreTold) {
    const auto checker = disc_checker(wall(0.5));
    const Configuration in_wall = {0, 1};
    MotionResult result = plan_motion(*checker, in_wall, kRight);
    EXPECT_EQ(result.status, MotionStatus::start_in_collision);
    ASSERT_EQ(result.contacts.size(), 1U);
    EXPECT_EQ(result.contacts[0].second, (Participant{Participant::Kind::body, 1}));
    result = plan_motion(*checker, kLeft, std::vector<Configuration>{in_wall});
    EXPECT_EQ(result.status, MotionStatus::goal_in_collision);
    EXPECT_EQ(result.contacts.size(), 1U);
    EXPECT_EQ(plan_motion(*checker, Configuration{2, 0}, kRight).status, MotionStatus::start_out_of_limits);
    const std::vector<Configuration> outside = {in_wall, {0, 9}};
    EXPECT_EQ(plan_motion(*checker, kLeft, outside).status, MotionStatus::goal_out_of_limits);
    EXPECT_EQ(plan_motion(*checker, kLeft, {}).status, MotionStatus::not_found);
    EXPECT_THROW(plan_motion(*checker, Configuration{0}, kRight), std::invalid_argument);
    EXPECT_THROW(plan_motion(*checker, Configuration{0, std::nan("")}, kRight), std::invalid_argument);
}

TEST(Planner, OneOfSeveralGoalsIsReached) {
    const auto checker = disc_checker(wall(0.3));  // too narrow
    const std::vector<Configuration> goals = {{0, 1}, {1, 0.7}, {-1, -1}, {5, 5}};
    const MotionResult result = plan_motion(*checker, kLeft, goals);
    ASSERT_EQ(result.status, MotionStatus::solved);
    EXPECT_EQ(result.goal, 2);
    EXPECT_EQ(result.path.back(), goals[2]);
}

TEST(Planner, TheSameSeedGivesTheSamePath) {
    const auto checker = disc_checker(wall(0.45));
    MotionOptions options;
    options.seed = 3;
    const Path path = plan_motion(*checker, kLeft, kRight, options).path;
    EXPECT_EQ(plan_motion(*disc_checker(wall(0.45)), kLeft, kRight, options).path, path);
    options.seed = 4;
    EXPECT_NE(plan_motion(*checker, kLeft, kRight, options).path, path);
}

TEST(Planner, ABudgetThatIsSpentEndsTheSearch) {
    const auto checker = disc_checker(wall(0.3));
    MotionOptions options;
    options.budget.limit_wall_time(0);
    const MotionResult result = plan_motion(*checker, kLeft, kRight, options);
    EXPECT_EQ(result.status, MotionStatus::not_found);
    EXPECT_LT(result.iterations, 100);
}

TEST(Planner, ContinuousVariablesGoTheShorterWay) {
    const auto robot = ball_arm(true);
    const int group = robot->find_group("all");
    const auto checker = make_fast_checker({robot, std::make_shared<const World>(), group, robot->zero()});
    Configuration start(10, 0.0);
    start[6] = -1.5;
    start[2] = 3;
    std::vector<Configuration> goals = {start};
    goals[0][2] = -3;
    const MotionResult result = plan_motion(*checker, start, goals);
    ASSERT_EQ(result.status, MotionStatus::solved);
    EXPECT_LT(path_length(result.path), 0.3);
    EXPECT_NEAR(result.path.back()[2], 2 * std::numbers::pi - 3, 1e-9);
}

/// Arms in random worlds: every path that is found is free for the exact checker, at every step.
TEST(Planner, CertifiedPathsOfAnArmAreFreeAtEveryStep) {
    const auto robot = ball_arm();
    Random random(21);
    int solved = 0;
    int shorter = 0;
    for (int i = 0; i < 20; ++i) {
        const auto world = std::make_shared<const World>(random_world(random, 10));
        const CollisionProblem problem = {robot, world, 0, robot->zero()};
        const auto fast = make_fast_checker(problem);
        const auto exact = make_fcl_checker(problem);
        const Configuration start = random_positions(*robot, robot->groups[0], random);
        const std::vector<Configuration> goals = {random_positions(*robot, robot->groups[0], random)};
        MotionOptions options;
        options.seed = static_cast<std::uint64_t>(i);
        options.max_iterations = 2000;
        const MotionResult result = plan_motion(*fast, start, goals, options);
        if (result.status != MotionStatus::solved) {
            EXPECT_TRUE(result.path.empty());
            continue;
        }
        ++solved;
        EXPECT_EQ(result.path.front(), start);
        EXPECT_EQ(result.path.back(), goals[0]);
        EXPECT_EQ(find_uncertified(*fast, result.path), -1);
        for (std::size_t k = 0; k + 1 < result.path.size(); ++k) {
            EXPECT_TRUE(robot->within_limits(robot->groups[0], result.path[k]));
            EXPECT_TRUE(exact->is_motion_free(result.path[k], result.path[k + 1], 1.0 / 300));
        }
        options.shorten = false;
        shorter += path_length(result.path) < path_length(plan_motion(*fast, start, goals, options).path);
    }
    EXPECT_GE(solved, 5);
    EXPECT_GE(shorter, 2);
}

/// A needle's eye that coarse steps jump over: certification must notice and repair.
TEST(Certify, EdgesThatJumpOverAThinWallAreReplaced) {
    const World thin = with_box(World(), "pin", 0, 0, {0.001, 0.001, 1});
    Robot point = *disc();
    point.links[2].collision = {{Pose::Identity(), Sphere{0.002}}};
    point.links[2].balls = {{Vector3::Zero(), 0.002}};
    const auto checker = make_fast_checker(
        {std::make_shared<const Robot>(point), std::make_shared<const World>(thin), 0, {0, 0}});
    Path path = {{-0.5, 0}, {0.497, 0}};
    ASSERT_TRUE(checker->is_motion_free(path[0], path[1], kCheckStep));
    EXPECT_EQ(find_uncertified(*checker, path), 0);
    ASSERT_TRUE(certify(*checker, path));
    EXPECT_GT(path.size(), 2U);
    EXPECT_EQ(find_uncertified(*checker, path), -1);
    EXPECT_EQ(path.front(), (Configuration{-0.5, 0}));
    EXPECT_EQ(path.back(), (Configuration{0.497, 0}));
}

TEST(Shortcut, EndsStayAndDetoursGo) {
    const auto checker = disc_checker(wall(0.5));
    Path path = {{-1, 0.7}, {-1, -1}, {-0.5, 0}, {0.5, 0}, {1, -1}, {1, 0.7}};
    const double before = path_length(path);
    shortcut(*checker, path);
    EXPECT_EQ(path.front(), kLeft);
    EXPECT_EQ(path.back(), kRight[0]);
    EXPECT_LT(path_length(path), 0.6 * before);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        EXPECT_TRUE(checker->is_motion_free(path[i], path[i + 1], kCheckStep));
    }
}

}  // namespace
}  // namespace praxis::tamp
