#include "tamp/collision/body_checker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tamp/scenes/occupancy_map.hpp"
#include "tests/tamp/collision/random_pose.hpp"

namespace praxis::tamp {
namespace {

std::shared_ptr<const BodyModel> body(const std::string& name, const Shape& shape) {
    BodyModel model;
    model.name = name;
    model.shapes.push_back({Pose::Identity(), shape});
    return std::make_shared<const BodyModel>(std::move(model));
}

bool touching(const Shape& first, const Pose& first_pose, const Shape& second, const Pose& second_pose) {
    const auto world = std::make_shared<const World>(
        World().with_body(body("first", first), first_pose).with_body(body("second", second), second_pose));
    return !BodyChecker(world).is_free(0, first_pose);
}

double distance(const Vector3& point, const Box& box, const Pose& pose) {
    const Vector3 half = 0.5 * box.size;
    const Vector3 local = pose.inverse() * point;
    return (local - local.cwiseMax(-half).cwiseMin(half)).norm();
}

double distance(const Vector3& point, const Cylinder& cylinder, const Pose& pose) {
    const Vector3 local = pose.inverse() * point;
    return std::hypot(std::max(local.head<2>().norm() - cylinder.radius, 0.0),
                      std::max(std::abs(local.z()) - 0.5 * cylinder.length, 0.0));
}

double distance_from_axis(const Vector3& point, const Capsule& capsule, const Pose& pose) {
    const Vector3 local = pose.inverse() * point;
    const double half = 0.5 * capsule.length;
    return (local - Vector3(0, 0, std::clamp(local.z(), -half, half))).norm();
}

/// Between the axes of two capsules. The distance from a segment is convex along a line.
double axis_distance(const Capsule& first, const Pose& first_pose, const Capsule& second,
                     const Pose& second_pose) {
    const auto at = [&](double z) {
        return distance_from_axis(first_pose * Vector3(0, 0, z), second, second_pose);
    };
    double lower = -0.5 * first.length;
    double upper = 0.5 * first.length;
    for (int i = 0; i < 100; ++i) {
        const double left = lower + (upper - lower) / 3;
        const double right = upper - (upper - lower) / 3;
        (at(left) < at(right) ? upper : lower) = at(left) < at(right) ? right : left;
    }
    return at(0.5 * (lower + upper));
}

/// Gottschalk's separating axes: how far apart the boxes are along the best of them; negative: they overlap.
double separation(const Box& first, const Pose& first_pose, const Box& second, const Pose& second_pose) {
    std::vector<Vector3> axes;
    for (int i = 0; i < 3; ++i) {
        axes.emplace_back(first_pose.linear().col(i));
        axes.emplace_back(second_pose.linear().col(i));
        for (int j = 0; j < 3; ++j) {
            const Vector3 cross = first_pose.linear().col(i).cross(second_pose.linear().col(j));
            if (cross.norm() > 1e-6) axes.emplace_back(cross.normalized());
        }
    }
    const Vector3 between = second_pose.translation() - first_pose.translation();
    double best = -std::numeric_limits<double>::infinity();
    for (const Vector3& axis : axes) {
        const double first_reach = 0.5 * (first_pose.linear().transpose() * axis).cwiseAbs().dot(first.size);
        const double second_reach =
            0.5 * (second_pose.linear().transpose() * axis).cwiseAbs().dot(second.size);
        best = std::max(best, std::abs(between.dot(axis)) - first_reach - second_reach);
    }
    return best;
}

/// Compares with a signed gap, unless that is too near to 0 to tell.
void expect_touching(const Shape& first, const Pose& first_pose, const Shape& second, const Pose& second_pose,
                     double gap) {
    if (std::abs(gap) < 1e-5) return;
    RC_ASSERT(touching(first, first_pose, second, second_pose) == (gap < 0));
    RC_ASSERT(touching(second, second_pose, first, first_pose) == (gap < 0));
}

RC_GTEST_PROP(BodyChecker, SpheresAgreeWithGeometry, (std::uint64_t seed)) {
    Random random(seed);
    const Sphere ball = {uniform(random, 0.02, 0.3)};
    const Pose pose = random_pose(random, 0.4);
    const Pose other = random_pose(random, 0.4);
    const Vector3 center = pose.translation();
    const auto size = [&] { return uniform(random, 0.02, 0.5); };

    const Sphere sphere = {size()};
    expect_touching(ball, pose, sphere, other,
                    (center - other.translation()).norm() - ball.radius - sphere.radius);
    const Box box = {{size(), size(), size()}};
    expect_touching(ball, pose, box, other, distance(center, box, other) - ball.radius);
    const Cylinder cylinder = {size(), size()};
    expect_touching(ball, pose, cylinder, other, distance(center, cylinder, other) - ball.radius);
    const Capsule capsule = {size(), size()};
    expect_touching(ball, pose, capsule, other,
                    distance_from_axis(center, capsule, other) - capsule.radius - ball.radius);
}

RC_GTEST_PROP(BodyChecker, BoxesAndCapsulesAgreeWithGeometry, (std::uint64_t seed)) {
    Random random(seed);
    const auto size = [&] { return uniform(random, 0.02, 0.5); };
    const Pose pose = random_pose(random, 0.4);
    const Pose other = random_pose(random, 0.4);
    const Box box = {{size(), size(), size()}};
    const Box second_box = {{size(), size(), size()}};
    expect_touching(box, pose, second_box, other, separation(box, pose, second_box, other));
    const Capsule capsule = {0.3 * size(), size()};
    const Capsule second_capsule = {0.3 * size(), size()};
    expect_touching(
        capsule, pose, second_capsule, other,
        axis_distance(capsule, pose, second_capsule, other) - capsule.radius - second_capsule.radius);
}

/// A tetrahedron with its right angle at the origin.
std::shared_ptr<const Mesh> tetrahedron() {
    Mesh mesh;
    mesh.name = "tetrahedron";
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return std::make_shared<const Mesh>(std::move(mesh));
}

TEST(BodyChecker, MeshesAreTheirSurface) {
    const Pose pose = pose_from_rpy({5, 0, 0}, {0, 0, 0.5});
    const auto touches = [&](const Vector3& point, double radius) {
        const Pose place = pose * pose_from_rpy(point, Vector3::Zero());
        return touching(tetrahedron(), pose, Sphere{radius}, place);
    };
    // The slanted face lies at (1 - sum of coordinates) / sqrt(3) from a point.
    EXPECT_TRUE(touches({0.4, 0.4, 0.4}, 0.2 / std::sqrt(3.0) + 1e-4));
    EXPECT_FALSE(touches({0.4, 0.4, 0.4}, 0.2 / std::sqrt(3.0) - 1e-4));
    EXPECT_TRUE(touches({0.2, 0.2, 0.2}, 0.21));
    EXPECT_FALSE(touches({0.2, 0.2, 0.2}, 0.19));  // inside
}

RC_GTEST_PROP(BodyChecker, MapsAreTheirVoxels, (std::uint64_t seed)) {
    Random random(seed);
    const VoxelGrid grid = {.origin = {-0.4, -0.4, -0.2}, .edge = 0.1, .cells = {8, 8, 4}};
    std::vector<Occupancy> cells(grid.size(), Occupancy::free);
    for (Occupancy& cell : cells) {
        if (random.below(30) == 0) cell = random.below(2) == 0 ? Occupancy::occupied : Occupancy::unknown;
    }
    const Pose pose = random_pose(random, 0.3);
    const std::vector<Shape> shapes = {Sphere{0.05}, Box{{0.1, 0.05, 0.2}}, Capsule{0.03, 0.2}};
    for (const bool unknown_blocks : {true, false}) {
        const auto map = std::make_shared<const OccupancyMap>(grid, cells, unknown_blocks);
        const VoxelSet obstacles = map->obstacles();
        for (const Shape& shape : shapes) {
            const Pose place = pose * random_pose(random, 0.4);
            bool expected = false;
            for (int k = 0; k < 4; ++k) {
                for (int j = 0; j < 8; ++j) {
                    for (int i = 0; i < 8; ++i) {
                        if (obstacles.filled[grid.index(i, j, k)] == 0) continue;
                        const Vector3 center =
                            Vector3(-0.4, -0.4, -0.2) + 0.1 * Vector3(i + 0.5, j + 0.5, k + 0.5);
                        expected = expected || touching(Box{{0.1, 0.1, 0.1}},
                                                        pose * Eigen::Translation3d(center), shape, place);
                    }
                }
            }
            RC_ASSERT(touching(map, pose, shape, place) == expected);
            RC_ASSERT(touching(shape, place, map, pose) == expected);
        }
        RC_ASSERT(touching(map, pose, map, pose) == !map->boxes().empty());
    }
}

TEST(BodyChecker, NamesWhoIsTouched) {
    const auto at = [](double x) { return pose_from_rpy({x, 0, 0}, Vector3::Zero()); };
    const Box cube = {{0.11, 0.11, 0.11}};
    World world;
    for (int i = 0; i < 5; ++i) world = world.with_body(body("cube" + std::to_string(i), cube), at(0.2 * i));
    world = world.with_allowed({Participant::Kind::body, 0}, {Participant::Kind::body, 4})
                .with_attached(3, {.link = 0});
    const BodyChecker checker(std::make_shared<const World>(world));
    EXPECT_EQ(checker.contacts(0, at(0.3)), (std::vector<int>{1, 2}));
    EXPECT_EQ(checker.contacts(0, at(0)), std::vector<int>{});    // not by itself
    EXPECT_EQ(checker.contacts(0, at(0.8)), std::vector<int>{});  // allowed
    EXPECT_EQ(checker.contacts(0, at(0.6)), std::vector<int>{});  // attached
    EXPECT_FALSE(checker.is_free(0, at(0.3), std::vector<int>{1}));
    EXPECT_TRUE(checker.is_free(0, at(0.3), std::vector<int>{1, 2}));
    EXPECT_THROW(checker.is_free(7, at(0)), std::invalid_argument);
}

TEST(BodyChecker, ShapesThatCannotBeAreRefused) {
    const auto make = [](const Shape& shape) {
        const auto world =
            std::make_shared<const World>(World().with_body(body("a", shape), Pose::Identity()));
        return BodyChecker(world);
    };
    Mesh broken = *tetrahedron();
    broken.triangles[0] = {0, 1, 9};
    EXPECT_THROW(make(Sphere{0}), std::invalid_argument);
    EXPECT_THROW(make(Box{{1, -1, 1}}), std::invalid_argument);
    EXPECT_THROW(make(Capsule{0.1, std::nan("")}), std::invalid_argument);
    EXPECT_THROW(make(std::make_shared<const Mesh>(broken)), std::invalid_argument);
    EXPECT_THROW(BodyChecker(nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
