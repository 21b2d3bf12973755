// An arm that is made of balls, and worlds of shapes at random.
#pragma once

#include <memory>
#include <string>

#include "search/engines/random.hpp"
#include "tamp/geometry/cover.hpp"
#include "tamp/scenes/world.hpp"
#include "tests/tamp/collision/random_pose.hpp"
#include "tests/tamp/support/panda.hpp"

namespace praxis::tamp {

/// The Panda's kinematics with a few balls a link; neighbours may touch.
inline std::shared_ptr<const Robot> ball_arm(bool mobile = false) {
    Robot robot = *panda_arm(mobile);
    Random random(5);
    for (std::size_t l = 0; l < robot.links.size(); ++l) {
        Link& link = robot.links[l];
        for (int i = 0; i < 3; ++i) {
            Pose pose = random_pose(random, 0.06);
            link.collision.push_back({pose, Sphere{uniform(random, 0.02, 0.06)}});
        }
        link.balls = cover(link.collision);
        link.bound = bounding_ball(link.balls);
        for (std::size_t other = l + 1; other < std::min(robot.links.size(), l + 4); ++other) {
            robot.allowed_collisions.emplace_back(static_cast<int>(l), static_cast<int>(other));
        }
    }
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

inline Shape random_shape(Random& random) {
    const auto size = [&] { return uniform(random, 0.03, 0.25); };
    switch (random.below(4)) {
        case 0: return Sphere{size()};
        case 1: return Box{{size(), size(), 2 * size()}};
        case 2: return Cylinder{size(), 2 * size()};
        default: return Capsule{size(), size()};
    }
}

/// Shapes around the origin, farther than `clear` from its upright axis; every other one stands upright.
inline World random_world(Random& random, int bodies, double clear = 0.5) {
    World world;
    for (int i = 0; i < bodies; ++i) {
        BodyModel model;
        model.name = "body" + std::to_string(i);
        model.shapes.push_back({Pose::Identity(), random_shape(random)});
        model.balls = cover(model.shapes);
        Pose pose = random_pose(random, 0.9);
        if (i % 2 == 0) pose.linear() = Eigen::AngleAxisd(uniform(random, -3, 3), Vector3::UnitZ()).matrix();
        while (pose.translation().head<2>().norm() < clear) pose.translation().head<2>() *= 2;
        world = world.with_body(std::make_shared<const BodyModel>(std::move(model)), pose);
    }
    return world;
}

/// Within the limits of the group (within a turn, where there are none).
inline Configuration random_positions(const Robot& robot, const Group& group, Random& random) {
    Configuration positions;
    for (int v : group.variables) {
        const Variable& variable = robot.variables[static_cast<std::size_t>(v)];
        const bool bounded = std::isfinite(variable.lower);
        positions.push_back(uniform(random, bounded ? variable.lower : -std::numbers::pi,
                                    bounded ? variable.upper : std::numbers::pi));
    }
    return positions;
}

}  // namespace praxis::tamp
