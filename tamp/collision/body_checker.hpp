// Contacts of bodies with bodies, without a robot: whether a placement is free.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

class SolidCache;
class StandingBodies;
struct Solid;

/// Exact, by FCL. Bodies that are attached are not looked at, pairs that the world allows neither. May be
/// used by several threads at once.
class BodyChecker {
  public:
    /// Throws std::invalid_argument if there is no world, or a shape in it cannot be.
    explicit BodyChecker(WorldPointer world, std::shared_ptr<SolidCache> cache = nullptr);
    ~BodyChecker();
    BodyChecker(BodyChecker&&) noexcept;
    BodyChecker& operator=(BodyChecker&&) noexcept;

    const World& world() const { return *world_; }
    /// Whether the body would touch no other one but those in `ignored` if it stood at `pose`. Throws
    /// std::invalid_argument if there is no such body or the pose is not finite.
    bool is_free(int body, const Pose& pose, std::span<const int> ignored = {}) const;
    /// Numbers of the bodies that it would touch, increasing.
    std::vector<int> contacts(int body, const Pose& pose) const;

  private:
    template <class Report>
    void each_contact(int body, const Pose& pose, Report&& report) const;

    WorldPointer world_;
    std::unique_ptr<const StandingBodies> standing_;
    std::vector<std::vector<Solid>> solids_;  ///< by body
};

}  // namespace praxis::tamp
