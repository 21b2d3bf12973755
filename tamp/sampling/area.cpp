#include "tamp/sampling/area.hpp"

namespace praxis::tamp {

std::map<std::string, Area, std::less<>> areas_of(const Scene& scene) {
    std::map<std::string, Area, std::less<>> areas;
    for (const Region& region : scene.regions) {
        const Surface& surface = scene.surfaces[static_cast<std::size_t>(region.surface)];
        areas[region.name] = {region.name, surface.body, surface.pose * region.pose, region.size};
    }
    for (const Surface& surface : scene.surfaces) {
        areas.try_emplace(surface.name, Area{surface.name, surface.body, surface.pose, surface.size});
    }
    return areas;
}

}  // namespace praxis::tamp
