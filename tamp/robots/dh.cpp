#include "tamp/robots/dh.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "tamp/robots/finish_robot.hpp"

namespace praxis::tamp {

namespace {

Pose screw(const Vector3& axis, double angle, double along) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    pose.translation() = along * axis;
    return pose;
}

/// What comes before the joint, and what comes after it.
struct Parts {
    Pose before = Pose::Identity();
    Pose after = Pose::Identity();
};

Parts parts(const DhRow& row, DhConvention convention) {
    const Pose along_x = screw(Vector3::UnitX(), row.alpha, row.a);
    const Pose along_z = screw(Vector3::UnitZ(), row.theta, row.d);
    if (convention == DhConvention::modified) return {along_x * along_z, Pose::Identity()};
    return {Pose::Identity(), along_z * along_x};
}

class DhMaker {
  public:
    explicit DhMaker(const DhTable& table) : table_(table) {}

    Robot make() {
        robot_.name = table_.name;
        add_link(table_.root, table_.root_shapes, Pose::Identity());
        for (const DhRow& row : table_.rows) add_row(row);
        const std::size_t count = robot_.links.size();
        for (std::size_t link = 1; link < count; ++link) add_end(static_cast<int>(link));
        return std::move(robot_);
    }

  private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw std::invalid_argument("robot '" + table_.name + "': " + why);
    }

    void add_link(const std::string& name, const std::vector<PlacedShape>& shapes, const Pose& row_frame) {
        if (name.empty()) refuse("a link has no name");
        if (robot_.find_link(name) >= 0) refuse("two links are named '" + name + "'");
        Link link{.name = name, .parent_joint = static_cast<int>(robot_.joints.size()) - 1};
        for (const PlacedShape& placed : shapes)
            link.collision.push_back({row_frame * placed.pose, placed.shape});
        robot_.links.push_back(std::move(link));
        row_frames_.push_back(row_frame);
    }

    Joint& add_joint(const std::string& name, JointType type, int parent, const Pose& origin) {
        if (name.empty()) refuse("a joint has no name");
        if (std::ranges::find(robot_.joints, name, &Joint::name) != robot_.joints.end()) {
            refuse("two joints are named '" + name + "'");
        }
        robot_.joints.push_back({.name = name,
                                 .type = type,
                                 .parent = parent,
                                 .child = static_cast<int>(robot_.links.size()),
                                 .origin = origin});
        return robot_.joints.back();
    }

    void add_row(const DhRow& row) {
        const int parent =
            row.parent.empty() ? static_cast<int>(robot_.links.size()) - 1 : robot_.find_link(row.parent);
        if (parent < 0) refuse("link '" + row.link + "' hangs from an unknown link '" + row.parent + "'");
        const Parts around = parts(row, table_.convention);
        Joint& joint = add_joint(row.joint, row.type, parent,
                                 row_frames_[static_cast<std::size_t>(parent)] * around.before);
        if (!row.mimic.empty()) {
            follow(row, joint);
        } else if (row.type != JointType::fixed) {
            joint.variable = static_cast<int>(robot_.variables.size());
            Variable variable = row.limits;
            variable.name = row.joint;
            variable.continuous = row.type == JointType::continuous;
            robot_.variables.push_back(std::move(variable));
        }
        add_link(row.link, row.shapes, around.after);
    }

    void follow(const DhRow& row, Joint& joint) {
        const auto master = std::ranges::find(robot_.joints, row.mimic, &Joint::name);
        if (row.type == JointType::fixed || master == robot_.joints.end() || master->variable < 0) {
            refuse("joint '" + row.joint + "' cannot mimic '" + row.mimic +
                   "'; name a moving joint of an earlier row");
        }
        joint.variable = master->variable;
        joint.multiplier = row.multiplier * master->multiplier;
        joint.offset = row.multiplier * master->offset + row.offset;
    }

    void add_end(int link) {
        const Pose frame = row_frames_[static_cast<std::size_t>(link)];
        const bool carries = std::ranges::find(robot_.joints, link, &Joint::parent) != robot_.joints.end();
        if (carries || frame.isApprox(Pose::Identity(), 0)) return;
        const std::string name = robot_.links[static_cast<std::size_t>(link)].name + "_end";
        add_joint(name, JointType::fixed, link, frame);
        add_link(name, {}, Pose::Identity());
    }

    const DhTable& table_;
    Robot robot_;
    std::vector<Pose> row_frames_;  ///< by link: the frame of its row in its own
};

}  // namespace

Pose dh_transform(const DhRow& row, DhConvention convention, double position) {
    DhRow moved = row;
    if (row.type == JointType::prismatic) {
        moved.d += position;
    } else if (row.type != JointType::fixed) {
        moved.theta += position;
    }
    const Parts around = parts(moved, convention);
    return around.before * around.after;
}

Robot make_dh_robot(const DhTable& table, const CoverOptions& options) {
    Robot robot = DhMaker(table).make();
    allow_neighbours(robot);
    check_robot(robot);
    cover_links(robot, options);
    return robot;
}

}  // namespace praxis::tamp
