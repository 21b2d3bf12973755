// Drives of a mobile base from home to where an arm can reach something, and what stands in their way.
//
// The base is at home before and after every skill, so all drives begin at one place: what is known of them
// is kept on a lattice (`base_lattice.hpp`), for the robot with empty hand at home and, where what it holds
// is in the way, for each grasp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "tamp/manipulation/skill_space.hpp"
#include "tamp/motion/base_lattice.hpp"

namespace praxis::tamp {

class Drives {
  public:
    using Id = SkillSpace::Id;

    /// Keeps a reference. The model has a base.
    explicit Drives(SkillSpace& space);

    /// The way on the lattice to where the base shall stand, holding `held` or with the hand empty, while
    /// these bodies stand. Valid until the next call.
    const LatticeSearch::Way& way(const std::vector<Id>& standing, std::optional<Id> held,
                                  const Configuration& goal);
    /// The path along it, with both ends; its edges are unchecked.
    Path path(const LatticeSearch::Way& way, const Configuration& goal) const;

  private:
    struct Shape {
        LatticeMap map;
        std::unordered_map<Id, std::vector<BaseLattice::Pose>> taken = {};  ///< by what stands
    };
    Shape& shape(std::optional<Id> held);
    const std::vector<BaseLattice::Pose>& taken(Shape& shape, std::optional<Id> held, Id standing);

    SkillSpace& space_;
    BaseLattice lattice_;
    double radius_;  ///< of the robot at home around the axis that its base turns about
    std::map<std::optional<Id>, Shape> shapes_;
    std::map<std::pair<std::optional<Id>, std::vector<Id>>, LatticeSearch>
        searches_;  ///< by shape, what stands
};

}  // namespace praxis::tamp
