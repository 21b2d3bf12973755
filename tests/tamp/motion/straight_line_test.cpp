#include "tamp/motion/straight_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/tamp/support/panda.hpp"
#include "tests/tamp/support/point_checker.hpp"

namespace praxis::tamp {
namespace {

const Configuration kReady = {0, -0.6, 0, -2.2, 0, 1.6, 0.8};

class PandaLine : public ::testing::Test {
  protected:
    std::shared_ptr<const Robot> robot = panda_arm();
    InverseKinematics ik{robot, 0, robot->groups[0].tip};
    Pose start = ik.forward(kReady);

    Pose moved(double x, double y, double z) const {
        Pose target = start;
        target.translation() += Vector3(x, y, z);
        return target;
    }
};

TEST_F(PandaLine, KeepsToTheLineAndTheOrientation) {
    const Pose target = moved(0.05, 0.1, -0.2);
    const StraightLine line = straight_line(ik, kReady, target);
    ASSERT_EQ(line.end, LineEnd::arrived);
    EXPECT_EQ(line.fraction, 1);
    EXPECT_EQ(line.path.front(), kReady);
    EXPECT_LT((ik.forward(line.path.back()).translation() - target.translation()).norm(), 1.01e-5);
    const Vector3 direction = (target.translation() - start.translation()).normalized();
    for (std::size_t i = 1; i < line.path.size(); ++i) {
        EXPECT_TRUE(robot->within_limits(robot->groups[0], line.path[i]));
        for (double share = 0; share <= 1; share += 0.25) {
            Configuration between = line.path[i];
            for (std::size_t j = 0; j < between.size(); ++j) {
                between[j] += share * (line.path[i - 1][j] - between[j]);
            }
            const Pose at = ik.forward(between);
            EXPECT_LT(direction.cross(at.translation() - start.translation()).norm(), 1.1e-3);
            EXPECT_LT(Eigen::AngleAxisd(at.linear().transpose() * start.linear()).angle(), 1.2e-3);
        }
    }
}

TEST_F(PandaLine, TurnsEvenlyOnTheWay) {
    const Pose target = moved(0, 0, -0.1) * pose_from_rpy(Vector3::Zero(), {0, 0, 1});
    const StraightLine line = straight_line(ik, kReady, target, {.turning_step = 0.125});
    ASSERT_EQ(line.end, LineEnd::arrived);
    ASSERT_EQ(line.path.size(), 9U);
    const Pose middle = ik.forward(line.path[4]);
    EXPECT_NEAR(middle.translation().z(), start.translation().z() - 0.05, 1e-4);
    EXPECT_NEAR(Eigen::AngleAxisd(start.linear().transpose() * middle.linear()).angle(), 0.5, 1e-3);
}

TEST_F(PandaLine, EndsWhereTheArmCannotGoOn) {
    const StraightLine line = straight_line(ik, kReady, moved(0.6, 0, 0));
    EXPECT_EQ(line.end, LineEnd::kinematics);
    EXPECT_GT(line.fraction, 0.2);
    EXPECT_LT(line.fraction, 1);
    EXPECT_NEAR(ik.forward(line.path.back()).translation().x(), start.translation().x() + 0.6 * line.fraction,
                1e-4);
}

TEST_F(PandaLine, EndsBeforeItTouches) {
    const double floor = start.translation().z() - 0.1;
    PointChecker checker(
        robot, [&](std::span<const double> at) { return ik.forward(at).translation().z() < floor; });
    StraightLineOptions options;
    options.checker = &checker;
    const StraightLine line = straight_line(ik, kReady, moved(0, 0, -0.2), options);
    EXPECT_EQ(line.end, LineEnd::collision);
    EXPECT_GT(line.fraction, 0.35);
    EXPECT_LE(line.fraction, 0.5);
    for (const Configuration& at : line.path) EXPECT_GE(ik.forward(at).translation().z(), floor);
    EXPECT_LT(ik.forward(line.blocked).translation().z(), floor);

    PointChecker everywhere(robot, [](std::span<const double>) { return true; });
    options.checker = &everywhere;
    const StraightLine none = straight_line(ik, kReady, moved(0, 0, -0.2), options);
    EXPECT_EQ(none.end, LineEnd::collision);
    EXPECT_EQ(none.fraction, 0);
    EXPECT_EQ(none.path, Path{kReady});
}

TEST_F(PandaLine, WrongUseIsRefused) {
    EXPECT_THROW(straight_line(ik, Configuration(6, 0), start), std::invalid_argument);
    EXPECT_THROW(straight_line(ik, Configuration(7, 9), start), std::invalid_argument);
    EXPECT_THROW(straight_line(ik, kReady, start, {.step = 0}), std::invalid_argument);
    EXPECT_THROW(straight_line(ik, kReady, start, {.deviation = -1}), std::invalid_argument);
    EXPECT_THROW(straight_line(ik, kReady, moved(1e9, 0, 0)), std::invalid_argument);
    EXPECT_THROW(straight_line(ik, kReady, moved(std::nan(""), 0, 0)), std::invalid_argument);
    PointChecker other(point_robot(), [](std::span<const double>) { return false; });
    StraightLineOptions options;
    options.checker = &other;
    EXPECT_THROW(straight_line(ik, kReady, start, options), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
