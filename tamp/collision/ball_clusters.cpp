#include "tamp/collision/ball_clusters.hpp"

#include <algorithm>
#include <span>

#include "tamp/collision/signed_distance.hpp"
#include "tamp/geometry/cover.hpp"

namespace praxis::tamp {

namespace {

/// How deep in one of the shapes; 0: in none.
double depth(const std::vector<PlacedShape>& shapes, const Vector3& point) {
    double deepest = 0;
    for (const PlacedShape& placed : shapes) {
        deepest = std::max(deepest, -signed_distance(placed.shape, placed.pose.inverse() * point));
    }
    return deepest;
}

std::vector<Ball> balls_of(const std::vector<PlacedShape>& shapes, const std::vector<Ball>& cover,
                           BallSide side, bool exact) {
    std::vector<Ball> balls;
    if (exact) {
        for (const PlacedShape& placed : shapes)
            balls.push_back({placed.pose.translation(), std::get<Sphere>(placed.shape).radius});
        return balls;
    }
    for (const Ball& ball : cover) {
        const double radius = side == BallSide::outer ? ball.radius : depth(shapes, ball.center);
        if (radius > 0) balls.push_back({ball.center, radius});
    }
    return balls;
}

/// Halves along the longest side until clusters are small.
void divide(std::span<Ball> balls, std::vector<BallClusters::Cluster>& clusters) {
    constexpr std::size_t kLargest = 4;
    if (balls.size() <= kLargest) {
        if (!balls.empty()) clusters.push_back({bounding_ball(balls), balls.size()});
        return;
    }
    Vector3 lower = balls.front().center;
    Vector3 upper = lower;
    for (const Ball& ball : balls) {
        lower = lower.cwiseMin(ball.center);
        upper = upper.cwiseMax(ball.center);
    }
    Eigen::Index longest = 0;
    (upper - lower).maxCoeff(&longest);
    std::ranges::stable_sort(balls, {}, [&](const Ball& ball) { return ball.center[longest]; });
    divide(balls.first(balls.size() / 2), clusters);
    divide(balls.subspan(balls.size() / 2), clusters);
}

}  // namespace

BallClusters cluster_balls(const std::vector<PlacedShape>& shapes, const std::vector<Ball>& cover,
                           BallSide side) {
    BallClusters result;
    result.exact = std::ranges::all_of(
        shapes, [](const PlacedShape& placed) { return std::holds_alternative<Sphere>(placed.shape); });
    if (shapes.empty()) result.exact = cover.empty();
    result.balls = balls_of(shapes, cover, side, result.exact);
    result.bound = bounding_ball(result.balls);
    divide(result.balls, result.clusters);
    return result;
}

}  // namespace praxis::tamp
