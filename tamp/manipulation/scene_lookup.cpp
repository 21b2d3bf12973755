#include "tamp/manipulation/scene_lookup.hpp"

#include <stdexcept>

namespace praxis::tamp {

int SceneLookup::body(const Value& value) const {
    const auto found = scene_->bodies.find(value.name());
    if (found == scene_->bodies.end()) {
        throw std::invalid_argument("the scene has no body for '" + value.name() + "'");
    }
    return found->second;
}

const Area& SceneLookup::area(const Value& value) const {
    const auto found = scene_->areas.find(value.name());
    if (found == scene_->areas.end()) {
        throw std::invalid_argument("the scene has no region '" + value.name() + "'");
    }
    return found->second;
}

World SceneLookup::world_at(std::span<const FluentAtom> fluents) const {
    World world = scene_->world;
    for (const FluentAtom& atom : fluents) {
        if (atom.predicate == "at")
            world = world.with_pose(body(atom.arguments[0]), atom.arguments[1].get<Pose>());
    }
    return world;
}

StreamResult SceneLookup::answer(const StreamCall& call, ActionResult result) const {
    if (result) return StreamResult::sample({Value::of(std::move(*result.motion))});
    ActionFailure& failure = result.failure;
    Blame blame{.reason = static_cast<Reason>(failure.reason),
                .message = failure.message,
                .each = failure.each,
                .definite = failure.definite};
    for (const int at_fault : failure.bodies) {
        for (std::uint32_t i = 0; i < call.fluents.size(); ++i) {
            if (body(call.fluents[i].arguments[0]) == at_fault) blame.fluents.push_back(i);
        }
    }
    const bool definite = failure.definite;
    blame.picture = Value::of(std::move(failure));
    return definite ? StreamResult::exhausted(std::move(blame)) : StreamResult::reject(std::move(blame));
}

}  // namespace praxis::tamp
