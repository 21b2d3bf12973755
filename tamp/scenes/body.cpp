#include "tamp/scenes/body.hpp"

#include <algorithm>
#include <stdexcept>

#include "tamp/geometry/cover.hpp"

namespace praxis::tamp {

namespace {

bool is_map(const PlacedShape& placed) {
    return std::holds_alternative<std::shared_ptr<const OccupancyMap>>(placed.shape);
}

}  // namespace

std::shared_ptr<const BodyModel> make_body(std::string name, std::vector<PlacedShape> shapes, bool movable,
                                           const std::array<float, 3>& color) {
    if (name.empty()) throw std::invalid_argument("a body needs a name");
    BodyModel body;
    if (std::ranges::none_of(shapes, is_map)) {
        try {
            body.balls = cover(shapes);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("body '" + name + "': " + error.what());
        }
    }
    body.name = std::move(name);
    body.shapes = std::move(shapes);
    body.movable = movable;
    body.color = color;
    return std::make_shared<const BodyModel>(std::move(body));
}

}  // namespace praxis::tamp
