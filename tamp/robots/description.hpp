// Robots described in YAML: a Denavit-Hartenberg table, shapes, groups, states and end effectors.
//
//     robot: arm2                       # name
//     convention: standard              # or modified (the default); see dh.hpp
//     base: {link: foot, shapes: [{sphere: {radius: 0.1}}]}            # optional
//     rows:
//       - {joint: shoulder, link: upper, a: 1, limits: [-3, 3], velocity: 2, acceleration: 5,
//          shapes: [{capsule: {radius: 0.05, from: [-1, 0, 0], to: [0, 0, 0]}}]}
//       - {joint: elbow, type: continuous, link: lower, a: 1}
//     groups: [{name: arm, joints: [shoulder, elbow], tip: lower_end}]
//     states: [{name: home, group: arm, positions: [0, 1]}]
//     end_effectors:
//       - {name: hand, link: lower_end, arm: arm, tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}, links: [lower]}
//     allowed_collisions: [[foot, lower]]
//
// Lengths are metres, angles radians. A row has `joint` and `link`; `type` (revolute, continuous, prismatic
// or fixed), `parent`, `a`, `alpha`, `d`, `theta` as in dh.hpp (numbers default to 0); `limits` (needed by
// revolute and prismatic joints), `velocity` (1 a second) and `acceleration` (twice the velocity a second);
// `mimic: {joint: NAME, multiplier: 1, offset: 0}`; and `shapes`, in the frame of the row: `sphere:
// {radius}`, `box: {size}`, `cylinder: {radius, length}`, `capsule: {radius, length}`, each also with `xyz`
// and `rpy`; cylinders and capsules may have `from` and `to` in place of `length`, `xyz` and `rpy`. An end
// effector may have `gripper`, `open` and `closed` (positions of that group), `max_opening`. Without `groups`
// they are derived, and without `allowed_collisions` too (derive.hpp).
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

/// Throw InputError naming file, line and mend.
Robot read_description(const std::string& file, const RobotOptions& options = {});
Robot parse_description(const Source& source, const RobotOptions& options = {});

}  // namespace praxis::tamp
