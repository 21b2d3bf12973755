#include "tamp/collision/ball_clusters.hpp"

#include <gtest/gtest.h>

#include "tamp/collision/solid.hpp"
#include "tamp/robots/builtin.hpp"
#include "tests/tamp/support/ball_arm.hpp"

namespace praxis::tamp {
namespace {

void expect_inside(const Ball& ball, const Ball& bound) {
    EXPECT_LE((ball.center - bound.center).norm() + ball.radius, bound.radius * (1 + 1e-9));
}

void expect_bounds(const BallClusters& clusters) {
    auto ball = clusters.balls.begin();
    for (const BallClusters::Cluster& cluster : clusters.clusters) {
        EXPECT_GT(cluster.ball_count, 0U);
        EXPECT_LE(cluster.ball_count, 4U);
        for (std::size_t i = 0; i < cluster.ball_count; ++i, ++ball) {
            ASSERT_NE(ball, clusters.balls.end());
            expect_inside(*ball, cluster.bound);
            expect_inside(*ball, clusters.bound);
        }
    }
    EXPECT_EQ(ball, clusters.balls.end());
}

TEST(BallClusters, BoundsHoldTheirBalls) {
    const Robot robot = builtin_robot("arm7");
    for (const Link& link : robot.links) {
        const BallClusters outer = cluster_balls(link.collision, link.balls, BallSide::outer);
        EXPECT_EQ(outer.balls.size(), link.balls.size());
        EXPECT_EQ(outer.exact, link.collision.empty());
        expect_bounds(outer);
        const BallClusters inner = cluster_balls(link.collision, link.balls, BallSide::inner);
        EXPECT_LE(inner.balls.size(), outer.balls.size());
        expect_bounds(inner);
    }
}

TEST(BallClusters, SpheresStandForThemselves) {
    const std::vector<PlacedShape> shapes = {{Pose::Identity(), Sphere{0.1}},
                                             {pose_from_rpy({1, 0, 0}, {0, 0, 0}), Sphere{0.2}}};
    for (const BallSide side : {BallSide::outer, BallSide::inner}) {
        const BallClusters clusters = cluster_balls(shapes, {}, side);
        EXPECT_TRUE(clusters.exact);
        ASSERT_EQ(clusters.balls.size(), 2U);
        EXPECT_DOUBLE_EQ(clusters.balls[0].radius + clusters.balls[1].radius, 0.3);
        expect_bounds(clusters);
    }
}

TEST(BallClusters, OfARobotAreMadeOnce) {
    const std::shared_ptr<const Robot> robot = ball_arm();
    SolidCache cache;
    const auto first = cache.clusters(robot);
    EXPECT_EQ(first->size(), robot->links.size());
    EXPECT_EQ(cache.clusters(robot), first);
    EXPECT_NE(cache.clusters(ball_arm()), first);
}

}  // namespace
}  // namespace praxis::tamp
