#include "tamp/geometry/mesh_cover.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

using Triangle = std::array<Vector3, 3>;

/// Triangles that one ball covers. The ball is taken for filled from its centre to the nearest of them: what
/// sticks out is its outer shell.
struct Cluster {
    std::vector<Triangle> triangles = {};
    Ball ball = {};
    double overhang = 0;
};

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("mesh '" + mesh.name + "' has no triangles to cover");
    }
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            if (corners[i] >= mesh.vertices.size()) {
                throw std::invalid_argument("mesh '" + mesh.name +
                                            "' has a triangle with an index out of range");
            }
            triangle[i] = mesh.vertices[corners[i]];
            if (!triangle[i].allFinite()) {
                throw std::invalid_argument("mesh '" + mesh.name + "' has a vertex that is not finite");
            }
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

double squared_longest_edge(const Triangle& triangle, std::size_t& opposite) {
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = (triangle[(i + 1) % 3] - triangle[(i + 2) % 3]).squaredNorm();
        if (length > longest) {
            longest = length;
            opposite = i;
        }
    }
    return longest;
}

/// Halves triangles at their longest edge until none is longer than `length` or there are enough.
void refine(std::vector<Triangle>& triangles, double length) {
    constexpr std::size_t kEnough = 200'000;
    for (std::size_t i = 0; i < triangles.size() && triangles.size() < kEnough;) {
        std::size_t apex = 0;
        if (squared_longest_edge(triangles[i], apex) <= length * length) {
            ++i;
            continue;
        }
        const Triangle whole = triangles[i];
        const Vector3 middle = (whole[(apex + 1) % 3] + whole[(apex + 2) % 3]) / 2;
        triangles[i] = {whole[apex], whole[(apex + 1) % 3], middle};
        triangles.push_back({whole[apex], middle, whole[(apex + 2) % 3]});
    }
}

Vector3 nearest_point(const Triangle& triangle, const Vector3& point) {
    // Regions of a triangle: C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
    const auto& [a, b, c] = triangle;
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    const double d1 = ab.dot(point - a);
    const double d2 = ac.dot(point - a);
    if (d1 <= 0 && d2 <= 0) return a;
    const double d3 = ab.dot(point - b);
    const double d4 = ac.dot(point - b);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
    const double d5 = ab.dot(point - c);
    const double d6 = ac.dot(point - c);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    return a + (ab * vb + ac * vc) / (va + vb + vc);
}

Cluster make_cluster(std::vector<Triangle> triangles) {
    Cluster cluster{std::move(triangles)};
    std::vector<Ball> corners;
    corners.reserve(3 * cluster.triangles.size());
    for (const Triangle& triangle : cluster.triangles) {
        for (const Vector3& corner : triangle) corners.push_back({corner, 0});
    }
    cluster.ball = bounding_ball(corners);
    double nearest = cluster.ball.radius;
    for (const Triangle& triangle : cluster.triangles) {
        nearest =
            std::min(nearest, (nearest_point(triangle, cluster.ball.center) - cluster.ball.center).norm());
    }
    cluster.overhang = cluster.ball.radius - nearest;
    return cluster;
}

/// Halves a cluster at the median along its longest side.
std::array<Cluster, 2> halve(Cluster& cluster) {
    Eigen::AlignedBox3d box;
    for (const Triangle& triangle : cluster.triangles) {
        for (const Vector3& corner : triangle) box.extend(corner);
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle = cluster.triangles.begin() + static_cast<std::ptrdiff_t>(cluster.triangles.size() / 2);
    std::ranges::nth_element(cluster.triangles, middle, {}, [&](const Triangle& triangle) {
        return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
    });
    std::vector<Triangle> upper(middle, cluster.triangles.end());
    cluster.triangles.erase(middle, cluster.triangles.end());
    return {make_cluster(std::move(cluster.triangles)), make_cluster(std::move(upper))};
}

}  // namespace

std::vector<Ball> cover_mesh(const Mesh& mesh, const CoverOptions& options) {
    std::vector<Triangle> triangles = triangles_of(mesh);
    Eigen::AlignedBox3d box;
    for (const Triangle& triangle : triangles) {
        for (const Vector3& corner : triangle) box.extend(corner);
    }
    refine(triangles, std::max(options.overhang, box.diagonal().norm() / 16));
    std::vector<Cluster> clusters;
    clusters.push_back(make_cluster(std::move(triangles)));
    while (clusters.size() < options.max_balls) {
        const auto worst = std::ranges::max_element(clusters, {}, &Cluster::overhang);
        if (worst->overhang <= options.overhang || worst->triangles.size() < 2) break;
        auto [lower, upper] = halve(*worst);
        *worst = std::move(lower);
        clusters.push_back(std::move(upper));
    }
    std::vector<Ball> balls;
    for (const Cluster& cluster : clusters) balls.push_back(cluster.ball);
    return balls;
}

}  // namespace praxis::tamp
