#include "tamp/motion/base_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "tamp/collision/fast_checker.hpp"

namespace praxis::tamp {
namespace {

using LatticePose = BaseLattice::Pose;

const AxisBox kHall{{-2, -2, 0}, {2, 2, 1}};
const Configuration kStart = {-1.5, 0.03, 0.2};

/// A beam of 0.8 m by 0.3 m that slides and turns on the floor.
std::shared_ptr<const Robot> beam() {
    Robot robot;
    robot.name = "beam";
    robot.links = {{.name = "root"},
                   {.name = "x-rail", .parent_joint = 0},
                   {.name = "y-rail", .parent_joint = 1},
                   {.name = "beam", .parent_joint = 2}};
    for (const double x : {-0.25, 0.0, 0.25}) {
        const Pose at(Eigen::Translation3d(x, 0, 0));
        robot.links[3].collision.push_back({at, Sphere{0.15}});
        robot.links[3].balls.push_back({at.translation(), 0.15});
    }
    constexpr std::array<const char*, 3> kNames = {"x", "y", "yaw"};
    for (int i = 0; i < 3; ++i) {
        const std::string name = kNames[static_cast<std::size_t>(i)];
        robot.joints.push_back({.name = name,
                                .type = i < 2 ? JointType::prismatic : JointType::revolute,
                                .parent = i,
                                .child = i + 1,
                                .axis = i == 0   ? Vector3::UnitX()
                                        : i == 1 ? Vector3::UnitY()
                                                 : Vector3::UnitZ(),
                                .variable = i});
        if (i < 2)
            robot.variables.push_back({.name = name, .lower = -2, .upper = 2});
        else
            robot.variables.push_back({.name = name, .continuous = true});
    }
    robot.groups = {{.name = "base", .variables = {0, 1, 2}, .tip = 3}};
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

World with_box(const World& world, const std::string& name, double x, double y, const Vector3& size) {
    BodyModel model;
    model.name = name;
    model.shapes.push_back({Pose::Identity(), Box{size}});
    return world.with_body(std::make_shared<const BodyModel>(std::move(model)),
                           Pose(Eigen::Translation3d(x, y, 0)));
}

std::unique_ptr<CollisionChecker> checker(const World& world) {
    static const std::shared_ptr<const Robot> robot = beam();
    return make_fast_checker({robot, std::make_shared<const World>(world), 0, robot->zero()});
}

/// A wall along y at x = 0, with doors of 0.6 m at y = -1 and, if wanted, y = 1.
World wall(bool second_door) {
    World world = with_box(World(), "below", 0, -1.65, {0.1, 0.7, 1});
    if (!second_door) return with_box(world, "above", 0, 0.65, {0.1, 2.7, 1});
    world = with_box(world, "between", 0, 0, {0.1, 1.4, 1});
    return with_box(world, "above", 0, 1.65, {0.1, 0.7, 1});
}

struct Hall {
    BaseLattice lattice{kStart, kHall};
    LatticeMap map;
    std::vector<std::vector<LatticePose>> taken;

    explicit Hall(const World& fixed) : map(lattice, checker(fixed)) {}
    void add(double x, double y, double size = 0.2) {
        const auto alone = checker(with_box(World(), "box", x, y, {size, size, 1}));
        taken.push_back(map.touching(*alone, x, y, 0.4 + size));
    }
    LatticeSearch search() {
        std::vector<const std::vector<LatticePose>*> all;
        for (const auto& poses : taken) all.push_back(&poses);
        return {map, all};
    }
};

const Configuration kGoal = {1.42, -0.61, -0.4};

TEST(BaseLattice, BeginsAtTheStart) {
    const BaseLattice lattice(kStart, kHall);
    EXPECT_EQ(lattice.positions(lattice.start()), kStart);
    EXPECT_NEAR(lattice.cell(), 0.1, 1e-12);
}

TEST(BaseLattice, NeighboursAreNeighboursOfEachOther) {
    const BaseLattice lattice(kStart, {{-1.75, -0.2, 0}, {-1.25, 0.3, 0}});
    const double step = std::numbers::pi / 4;
    std::size_t edges = 0;
    for (LatticePose pose = 0; pose < lattice.size(); ++pose) {
        lattice.visit_neighbours(pose, [&](LatticePose next, std::uint32_t length) {
            ++edges;
            const Configuration from = lattice.positions(pose), to = lattice.positions(next);
            const double way = std::hypot(to[0] - from[0], to[1] - from[1]);
            const double turn = std::abs(to[2] - from[2]);
            EXPECT_NEAR(length, way > 0 ? way * 1000 : 100, 1);
            EXPECT_NEAR(turn, way > 0 ? 0 : step, 1e-12);
            bool back = false;
            lattice.visit_neighbours(next,
                                     [&](LatticePose again, std::uint32_t) { back = back || again == pose; });
            EXPECT_TRUE(back);
        });
    }
    // 5 by 5 cells and 9 yaws: straight, diagonal, turns; each from both sides.
    EXPECT_EQ(lattice.size(), 5U * 5 * 9);
    EXPECT_EQ(edges, 2U * (9 * (2 * 5 * 4 + 2 * 4 * 4) + 25 * 8));
}

TEST(BaseLattice, WhatIsAroundIsNear) {
    const BaseLattice lattice(kStart, kHall);
    const std::vector<LatticePose> around = lattice.around(kGoal);
    ASSERT_EQ(around.size(), 8U);
    for (const LatticePose pose : around) {
        const Configuration at = lattice.positions(pose);
        EXPECT_LT(std::abs(at[0] - kGoal[0]), 0.1);
        EXPECT_LT(std::abs(at[1] - kGoal[1]), 0.1);
        EXPECT_LT(std::abs(at[2] - kGoal[2]), std::numbers::pi / 4);
    }
    EXPECT_EQ(lattice.around(lattice.positions(77)).front(), 77U);
    EXPECT_TRUE(lattice.around({5, 0, 0}).empty());
    EXPECT_TRUE(lattice.around({0, 0, 40}).empty());
}

TEST(BaseLattice, CellsGrowInHugeHalls) {
    const BaseLattice lattice(kStart, {{-1e6, -1e6, 0}, {1e6, 1e6, 0}});
    EXPECT_LE(lattice.size(), BaseLatticeOptions().most_poses * 2);
    EXPECT_EQ(lattice.positions(lattice.start()), kStart);
    const BaseLattice narrow(kStart, {{-1e9, 0, 0}, {1e9, 0.1, 0}});
    EXPECT_LE(narrow.size(), BaseLatticeOptions().most_poses * 2);
}

TEST(LatticeMap, ABodyTakesThePosesThatTouchIt) {
    Hall hall(World{});
    hall.add(0.5, 0.2);
    const auto alone = checker(with_box(World(), "box", 0.5, 0.2, {0.2, 0.2, 1}));
    const std::set<LatticePose> taken(hall.taken[0].begin(), hall.taken[0].end());
    EXPECT_GT(taken.size(), 20U);
    for (LatticePose pose = 0; pose < hall.lattice.size(); ++pose)
        ASSERT_EQ(taken.contains(pose), !alone->is_free(hall.lattice.positions(pose)));
}

TEST(LatticeSearch, WaysAreFreeAndJoined) {
    Hall hall(wall(true));
    hall.add(0, -1);
    LatticeSearch search = hall.search();
    const LatticeSearch::Way& way = search.to(kGoal);
    ASSERT_TRUE(way.found);
    EXPECT_TRUE(way.bodies.empty());
    EXPECT_EQ(way.poses.front(), hall.lattice.start());
    const auto all = checker(with_box(wall(true), "box", 0, -1, {0.2, 0.2, 1}));
    for (const LatticePose pose : way.poses) EXPECT_TRUE(all->is_free(hall.lattice.positions(pose)));
    for (std::size_t i = 0; i + 1 < way.poses.size(); ++i) {
        bool joined = false;
        hall.lattice.visit_neighbours(way.poses[i], [&](LatticePose next, std::uint32_t) {
            joined = joined || next == way.poses[i + 1];
        });
        EXPECT_TRUE(joined);
    }
}

TEST(LatticeSearch, TheFewestBodiesAreNamed) {
    Hall hall(wall(true));
    hall.add(-0.1, -1);  // two in the nearer door, one behind the other
    hall.add(0, 1);
    hall.add(0.2, -1);
    hall.add(1, 1.5);  // in nobody's way
    LatticeSearch search = hall.search();
    const LatticeSearch::Way& way = search.to(kGoal);
    ASSERT_TRUE(way.found);
    EXPECT_EQ(way.bodies, std::vector<int>{1});
    EXPECT_TRUE(search.to({-1, -1, 0}).bodies.empty());
    EXPECT_EQ(search.to(kGoal).bodies, std::vector<int>{1});
}

TEST(LatticeSearch, AllOnTheOnlyWayAreNamed) {
    Hall hall(wall(false));
    hall.add(-0.5, -1, 0.6);
    hall.add(0, 1);
    hall.add(0.3, -1);
    hall.taken[0] =
        hall.map.touching(*checker(with_box(World(), "barrier", -0.5, 0, {0.1, 4, 1})), -0.5, 0, 9);
    LatticeSearch search = hall.search();
    EXPECT_EQ(search.to(kGoal).bodies, (std::vector<int>{0, 2}));
}

TEST(LatticeSearch, WhereBodiesDoNotMatterThereIsNoWay) {
    Hall hall(with_box(World(), "wall", 0, 0, {0.1, 5, 1}));
    hall.add(-0.5, -1);
    LatticeSearch search = hall.search();
    EXPECT_FALSE(search.to(kGoal).found);
    EXPECT_FALSE(search.to({50, 0, 0}).found);
    EXPECT_TRUE(search.to({-1, 1, 0}).found);
}

TEST(LatticeSearch, TheOrderOfQuestionsDoesNotMatter) {
    Hall hall(wall(true));
    hall.add(0, -1);
    hall.add(0.1, 1);
    const std::vector<Configuration> goals = {
        {-1, 1, 0}, kGoal, {1, 1, 1}, {-0.6, -1.2, 0.5}, {1.5, 1.5, -2}};
    LatticeSearch forward = hall.search();
    LatticeSearch backward = hall.search();
    std::vector<std::vector<int>> bodies;
    for (const Configuration& goal : goals) bodies.push_back(forward.to(goal).bodies);
    for (std::size_t i = goals.size(); i-- > 0;) EXPECT_EQ(backward.to(goals[i]).bodies, bodies[i]);
}

}  // namespace
}  // namespace praxis::tamp
