// The bodies of a world that stand (are not attached), ready for collision checks.
#pragma once

#include <vector>

#include "tamp/collision/solid.hpp"
#include "tamp/geometry/box_tree.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

class StandingBodies {
  public:
    /// One shape of a body where it stands.
    struct Part {
        int body = 0;
        Solid solid = {};
        Pose pose = Pose::Identity();  ///< of the shape in the world
        AxisBox box = {};              ///< around it, in the world
    };

    StandingBodies(const World& world, SolidCache& cache);

    const Part& operator[](std::size_t part) const { return parts_[part]; }
    /// Over the boxes of all parts.
    const BoxTree& tree() const { return tree_; }

  private:
    std::vector<Part> parts_;
    BoxTree tree_;
};

}  // namespace praxis::tamp
