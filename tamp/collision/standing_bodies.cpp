#include "tamp/collision/standing_bodies.hpp"

namespace praxis::tamp {

StandingBodies::StandingBodies(const World& world, SolidCache& cache) {
    std::vector<AxisBox> boxes;
    for (int body = 0; static_cast<std::size_t>(body) < world.size(); ++body) {
        if (world[body].attachment) continue;
        for (Solid& solid : cache.make(world[body].model->shapes)) {
            const Pose pose = world[body].pose * solid.pose;
            const AxisBox box = moved(solid.extent, pose);
            boxes.push_back(box);
            parts_.push_back({body, std::move(solid), pose, box});
        }
    }
    tree_ = BoxTree(boxes);
}

}  // namespace praxis::tamp
