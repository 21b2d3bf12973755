// Parts of a trajectory document made of robots, worlds, trajectories and contacts.
#pragma once

#include "tamp/report/trajectory_document.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A document that holds the robot, the bodies as they stand (or are held) in `world`, and `start`; no plan
/// yet. Links show their visual shapes, or what collides where they have none.
TrajectoryDocument begin_document(const Robot& robot, const World& world, const Configuration& start);

/// `trajectory` of `group` as a segment of action number `action` that begins at `start` seconds.
TrajectoryDocument::Segment describe_motion(const Group& group, const Trajectory& trajectory, int action,
                                            TrajectoryDocument::Motion kind, double start);

TrajectoryDocument::Hold describe_hold(const Robot& robot, const World& world, int body,
                                       const Attachment& attachment);
TrajectoryDocument::Stand describe_stand(const World& world, int body, const Pose& pose);

/// The names of two that touch.
std::pair<std::string, std::string> describe_contact(const Robot& robot, const World& world,
                                                     const Contact& contact);

/// A failure in `world` (what was held, and what no longer stands as in `first`, come from it).
TrajectoryDocument::Attempt describe_attempt(const Robot& robot, const World& first, const World& world,
                                             const Configuration& configuration,
                                             const std::vector<Contact>& contacts);

}  // namespace praxis::tamp
