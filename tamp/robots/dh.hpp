// Robots out of Denavit-Hartenberg tables.
//
// A row takes from the frame of one link to that of the next by a screw along x and a screw along z. In the
// *standard* convention the joint's screw comes first: T = Rz(theta) Tz(d) Tx(a) Rx(alpha); the joint turns
// about z of the link before, and the row's frame sits at the far end of the link. In the *modified* one (J.
// J. Craig, "Introduction to Robotics", 3rd edition, section 3.4) the joint comes last: T = Rx(alpha) Tx(a)
// Rz(theta) Tz(d), with a(i-1) and alpha(i-1) in row i, and the row's frame sits on the joint. A revolute
// joint adds its position to theta, a prismatic one to d.
//
// Frames of links stand on their joints here, in both conventions. So in the standard one a link's frame is
// not that of its row: shapes are given in the row's frame and moved, and a link that no other hangs from
// gets a link without shapes at the frame of its row, named NAME_end.
#pragma once

#include <string>
#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

enum class DhConvention : std::uint8_t { standard, modified };

struct DhRow {
    std::string joint = {};                ///< name
    std::string link = {};                 ///< name
    std::string parent = {};               ///< link that this one hangs from; empty: that of the row before
    JointType type = JointType::revolute;  ///< fixed: theta and d are all there is
    double a = 0;
    double alpha = 0;
    double d = 0;
    double theta = 0;
    Variable limits = {};    ///< of the joint, which also gives its name
    std::string mimic = {};  ///< joint of an earlier row whose variable this one shares; empty: its own
    double multiplier = 1;   ///< of a joint that mimics
    double offset = 0;       ///< of a joint that mimics
    std::vector<PlacedShape> shapes = {};  ///< in the frame of the row
};

struct DhTable {
    std::string name = {};  ///< of the robot
    DhConvention convention = DhConvention::modified;
    std::string root = "base";  ///< name of the link that the first row hangs from
    std::vector<PlacedShape> root_shapes = {};
    std::vector<DhRow> rows = {};
};

/// The frame of a row in that of the row before, at a position of its joint.
Pose dh_transform(const DhRow& row, DhConvention convention, double position);

/// The robot's links, joints and variables, with covers; neighbours may touch. Without groups, states and end
/// effectors. Throws std::invalid_argument for names that are missing, repeated or unknown, and for all
/// that `check_robot` refuses.
Robot make_dh_robot(const DhTable& table, const CoverOptions& options = {});

}  // namespace praxis::tamp
