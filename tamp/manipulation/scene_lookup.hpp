// What the values and atoms of a stream call are in a scene, and what a failed skill is to the planner.
#pragma once

#include <memory>
#include <span>

#include "tamp/manipulation/action_motion.hpp"
#include "tamp/manipulation/pick_place_streams.hpp"

namespace praxis::tamp {

class SceneLookup {
  public:
    explicit SceneLookup(std::shared_ptr<const PickPlaceScene> scene) : scene_(std::move(scene)) {}

    const PickPlaceScene& scene() const { return *scene_; }
    /// By the object's name. Both throw std::invalid_argument if the scene has none.
    int body(const Value& value) const;
    const Area& area(const Value& value) const;
    /// The scene's world with every body of an atom `(at BODY POSE)` at its pose.
    World world_at(std::span<const FluentAtom> fluents) const;
    /// A motion, or why there is none: the bodies at fault are the atoms that say where they stand.
    StreamResult answer(const StreamCall& call, ActionResult result) const;

  private:
    std::shared_ptr<const PickPlaceScene> scene_;
};

}  // namespace praxis::tamp
