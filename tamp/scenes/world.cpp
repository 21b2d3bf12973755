#include "tamp/scenes/world.hpp"

#include <algorithm>
#include <stdexcept>

namespace praxis::tamp {

namespace {

Contact ordered(const Participant& first, const Participant& second) {
    return first < second ? Contact{first, second} : Contact{second, first};
}

void require_body(const std::vector<BodyState>& bodies, int body) {
    if (body < 0 || static_cast<std::size_t>(body) >= bodies.size()) {
        throw std::invalid_argument("there is no body number " + std::to_string(body));
    }
}

void require_finite(const Pose& pose, const std::string& name) {
    if (!is_finite(pose)) throw std::invalid_argument("the pose of body '" + name + "' is not finite");
}

}  // namespace

int World::find(std::string_view name) const {
    const auto found =
        std::ranges::find_if(bodies_, [&](const BodyState& body) { return body.model->name == name; });
    return found == bodies_.end() ? -1 : static_cast<int>(found - bodies_.begin());
}

bool World::allowed(const Participant& first, const Participant& second) const {
    return std::ranges::binary_search(allowed_, ordered(first, second));
}

World World::with_body(std::shared_ptr<const BodyModel> model, const Pose& pose) const {
    require_finite(pose, model->name);
    if (find(model->name) >= 0) {
        throw std::invalid_argument("there is a body '" + model->name + "' already");
    }
    World world = *this;
    world.bodies_.push_back({std::move(model), pose, std::nullopt});
    return world;
}

World World::with_pose(int body, const Pose& pose) const {
    require_body(bodies_, body);
    require_finite(pose, bodies_[static_cast<std::size_t>(body)].model->name);
    World world = *this;
    BodyState& state = world.bodies_[static_cast<std::size_t>(body)];
    state.pose = pose;
    state.attachment.reset();
    return world;
}

World World::with_attached(int body, const Attachment& attachment) const {
    require_body(bodies_, body);
    require_finite(attachment.in_link, bodies_[static_cast<std::size_t>(body)].model->name);
    World world = *this;
    world.bodies_[static_cast<std::size_t>(body)].attachment = attachment;
    return world;
}

World World::with_allowed(const Participant& first, const Participant& second) const {
    World world = *this;
    const Contact pair = ordered(first, second);
    const auto place = std::ranges::lower_bound(world.allowed_, pair);
    if (place == world.allowed_.end() || *place != pair) world.allowed_.insert(place, pair);
    return world;
}

}  // namespace praxis::tamp
