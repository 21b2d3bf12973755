// The hand of a robot on its own, flying where it is told: hand and fingers alone, without the arm that
// carries them. What stops it stops the arm, however that bends: no inverse kinematics is needed to know.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

struct FlyingHand {
    std::shared_ptr<const Robot> robot;
    int group = 0;               ///< x, y, z, and the turns about z, y and x of the link that holds bodies
    int frame = 0;               ///< the link that stands for the one that holds bodies
    std::vector<int> links;      ///< by link of the whole robot: its number here, or -1
    std::vector<int> variables;  ///< of the whole robot, by variable here behind those of the group

    /// Positions of the group that bring the link that holds bodies to `pose`.
    static Configuration at(const Pose& pose);
    /// The fingers as in a configuration of the whole robot.
    Configuration rest(const Configuration& whole) const;
    Attachment attachment(const Attachment& whole) const;
};

/// `home`: the links of the hand that no finger moves keep their places of this configuration.
FlyingHand make_flying_hand(const Robot& robot, const EndEffector& effector, const Configuration& home);

/// The arm without its hand: the same links, but those of the hand are empty.
std::shared_ptr<const Robot> make_bare_arm(const Robot& robot, const EndEffector& effector);

/// A world of some bodies of another one alone, in their order. `links`: new numbers of the robot's links in
/// the list of who may touch whom (-1: left out).
World part_of(const World& world, std::span<const int> bodies, std::span<const int> links);

}  // namespace praxis::tamp
