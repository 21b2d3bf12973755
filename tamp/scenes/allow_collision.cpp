#include "tamp/scenes/allow_collision.hpp"

#include <algorithm>

namespace praxis::tamp {

using Kind = Participant::Kind;

std::optional<Participant> find_participant(const Robot& robot, const World& world, std::string_view name) {
    const int link = robot.find_link(name);
    if (link >= 0) return Participant{Kind::link, link};
    const int body = world.find(name);
    if (body >= 0) return Participant{Kind::body, body};
    return std::nullopt;
}

void allow_collision(Robot& robot, World& world, const Participant& first, const Participant& second) {
    if (first.kind == Kind::body || second.kind == Kind::body) {
        world = world.with_allowed(first, second);
        return;
    }
    const std::pair<int, int> pair = std::minmax(first.index, second.index);
    auto& allowed = robot.allowed_collisions;
    const auto place = std::ranges::lower_bound(allowed, pair);
    if (place == allowed.end() || *place != pair) allowed.insert(place, pair);
}

}  // namespace praxis::tamp
