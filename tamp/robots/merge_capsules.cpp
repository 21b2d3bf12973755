#include "tamp/robots/merge_capsules.hpp"

#include <cmath>

namespace praxis::tamp {

namespace {

constexpr double kTolerance = 1e-6;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t find_sphere(const std::vector<PlacedShape>& shapes, const Vector3& center, double radius) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto* sphere = std::get_if<Sphere>(&shapes[i].shape);
        if (sphere != nullptr && std::abs(sphere->radius - radius) < kTolerance &&
            (shapes[i].pose.translation() - center).norm() < kTolerance) {
            return i;
        }
    }
    return kNone;
}

}  // namespace

void merge_capsules(std::vector<PlacedShape>& shapes) {
    std::vector<bool> merged(shapes.size());
    std::vector<PlacedShape> capsules;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const auto* cylinder = std::get_if<Cylinder>(&shapes[i].shape);
        if (cylinder == nullptr) continue;
        const Vector3 end(0, 0, cylinder->length / 2);
        const std::size_t upper = find_sphere(shapes, shapes[i].pose * end, cylinder->radius);
        const std::size_t lower = find_sphere(shapes, shapes[i].pose * Vector3(-end), cylinder->radius);
        if (upper == kNone || lower == kNone) continue;
        capsules.push_back({shapes[i].pose, Capsule{cylinder->radius, cylinder->length}});
        merged[i] = merged[upper] = merged[lower] = true;
    }
    std::vector<PlacedShape> kept;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!merged[i]) kept.push_back(std::move(shapes[i]));
    }
    kept.insert(kept.end(), capsules.begin(), capsules.end());
    shapes = std::move(kept);
}

}  // namespace praxis::tamp
