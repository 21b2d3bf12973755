#include "tamp/report/describe.hpp"

#include <gtest/gtest.h>

#include "tamp/scenes/occupancy_map.hpp"
#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

std::shared_ptr<const BodyModel> body(const char* name, const Shape& shape) {
    BodyModel model;
    model.name = name;
    model.shapes = {{Pose::Identity(), shape}};
    model.movable = true;
    return std::make_shared<const BodyModel>(std::move(model));
}

Pose shifted(double x) {
    return Pose(Eigen::Translation3d(x, 0, 0));
}

TEST(Describe, TakesWhatIsSeenForLinks) {
    Robot robot = sample_robot();
    robot.links[1].visual = {{shifted(1), Sphere{0.5}}};
    const TrajectoryDocument document = begin_document(robot, World(), robot.zero());
    ASSERT_EQ(document.robot.links.size(), robot.links.size());
    EXPECT_EQ(std::get<Sphere>(document.robot.links[1].shapes[0].shape).radius, 0.5);
    EXPECT_EQ(document.robot.links[1].shapes[0].pose[0], 1);
    EXPECT_EQ(document.robot.links[0].shapes.size(), robot.links[0].collision.size());
    EXPECT_EQ(document.robot.links[3].parent, 2);
    EXPECT_EQ(document.robot.tools[0].name, "hand");
}

TEST(Describe, HasWhatIsHeldAtTheStart) {
    const Robot robot = sample_robot();
    const int hand = robot.find_link("hand");
    World world = World().with_body(body("cup", Sphere{0.1}), shifted(1));
    world = world.with_attached(0, {hand, shifted(0.2), {}});
    const TrajectoryDocument document = begin_document(robot, world, robot.zero());
    check_document(document);
    ASSERT_EQ(document.held.size(), 1u);
    EXPECT_EQ(document.held[0].link, "hand");
    EXPECT_EQ(document.held[0].pose[0], 0.2);
    const Pose expected = link_pose(robot, robot.zero(), hand) * shifted(0.2);
    EXPECT_TRUE(pose_from_numbers(document.bodies[0].pose).isApprox(expected, 1e-12));
}

TEST(Describe, AnAttemptSaysWhatStandsElsewhere) {
    const Robot robot = sample_robot();
    const World first = World()
                            .with_body(body("cup", Sphere{0.1}), shifted(1))
                            .with_body(body("can", Sphere{0.1}), shifted(2));
    const World moved =
        first.with_pose(0, shifted(3)).with_attached(1, {robot.find_link("hand"), shifted(0), {}});
    const Contact contact{{Participant::Kind::link, 2}, {Participant::Kind::body, 0}};
    const TrajectoryDocument::Attempt attempt =
        describe_attempt(robot, first, moved, robot.zero(), {contact});
    ASSERT_EQ(attempt.elsewhere.size(), 1u);
    EXPECT_EQ(attempt.elsewhere[0].body, "cup");
    EXPECT_EQ(attempt.elsewhere[0].pose[0], 3);
    ASSERT_TRUE(attempt.held);
    EXPECT_EQ(attempt.held->body, "can");
    EXPECT_EQ(attempt.contacts[0], std::make_pair(robot.links[2].name, std::string("cup")));
    EXPECT_TRUE(describe_attempt(robot, first, first, robot.zero(), {}).elsewhere.empty());
}

TEST(Describe, ShowsOccupiedVoxelsThatCanBeSeen) {
    VoxelGrid grid;
    grid.origin = {1, 2, 3};
    grid.edge = 0.1;
    grid.cells = {4, 3, 3};
    std::vector<Occupancy> cells(grid.size(), Occupancy::unknown);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) cells[grid.index(i, j, k)] = Occupancy::occupied;
    const auto map = std::make_shared<const OccupancyMap>(grid, cells);
    const World world = World().with_body(body("cloud", map), Pose::Identity());
    const Robot robot = sample_robot();
    const TrajectoryDocument document = begin_document(robot, world, robot.zero());
    const auto& voxels = std::get<TrajectoryDocument::Voxels>(document.bodies[0].shapes[0].shape);
    EXPECT_EQ(voxels.edge, 0.1);
    EXPECT_EQ(voxels.centers.size(), 26u);
    EXPECT_TRUE(voxels.centers[0].isApprox(Vector3(1.05, 2.05, 3.05), 1e-12));
}

}  // namespace
}  // namespace praxis::tamp
