#include "tamp/robots/urdf.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <mutex>
#include <stdexcept>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/geometry/mesh_file.hpp"
#include "tamp/robots/find_resource.hpp"
#include "tamp/robots/finish_robot.hpp"
#include "tamp/robots/merge_capsules.hpp"
#include "tamp/robots/urdf_tree.hpp"

namespace praxis::tamp {

namespace {

/// Collects what urdfdom would print.
class Complaints final : public console_bridge::OutputHandler {
  public:
    Complaints() { console_bridge::useOutputHandler(this); }
    ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
    Complaints(const Complaints&) = delete;
    Complaints& operator=(const Complaints&) = delete;

    void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
        if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
        if (!text_.empty()) text_ += "; ";
        text_ += text;
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Complaints name elements in brackets or quotes.
const tinyxml2::XMLElement* blamed(const std::string& complaints,
                                   const std::map<std::string, const tinyxml2::XMLElement*>& elements) {
    for (const auto& [name, element] : elements) {
        if (complaints.find('[' + name + ']') != std::string::npos ||
            complaints.find('\'' + name + '\'') != std::string::npos) {
            return element;
        }
    }
    return nullptr;
}

/// Two readers of XML may see different names in odd characters.
void require_same_names(const XmlFile& xml, const UrdfTree& tree, const urdf::ModelInterface& model) {
    const char* const odd = "a name has characters that cannot be read";
    for (const auto& [name, element] : tree.link_elements) {
        if (!model.getLink(name)) xml.fail(*element, odd);
    }
    for (const auto& [name, element] : tree.joint_elements) {
        const auto joint = model.getJoint(name);
        if (!joint || !tree.link_elements.contains(joint->parent_link_name)) xml.fail(*element, odd);
    }
}

urdf::ModelInterfaceSharedPtr parse_model(const XmlFile& xml, const UrdfTree& tree) {
    // The handler of messages is one for the whole process.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    Complaints complaints;
    urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(xml.source().text);
    if (model && complaints.text().empty()) {
        require_same_names(xml, tree, *model);
        return model;
    }
    const tinyxml2::XMLElement* joint = blamed(complaints.text(), tree.joint_elements);
    const tinyxml2::XMLElement* link = blamed(complaints.text(), tree.link_elements);
    const tinyxml2::XMLElement& element = joint != nullptr ? *joint : link != nullptr ? *link : xml.root();
    xml.fail(element, complaints.text().empty() ? "this is no URDF" : complaints.text());
}

Vector3 to_vector(const urdf::Vector3& vector) {
    return {vector.x, vector.y, vector.z};
}

class UrdfReader {
  public:
    UrdfReader(const XmlFile& xml, const RobotOptions& options)
        : xml_(xml), options_(options), tree_(make_urdf_tree(xml)), model_(parse_model(xml, tree_)) {}

    Robot read() {
        robot_.name = model_->getName();
        add_link(tree_.root, -1);
        for (const std::string& name : tree_.joints) add_joint(*model_->getJoint(name));
        for (const std::string& name : tree_.joints) resolve_mimic(*model_->getJoint(name));
        return std::move(robot_);
    }

  private:
    [[noreturn]] void fail_at_joint(const urdf::Joint& joint, const std::string& message,
                                    const std::string& hint = {}) const {
        xml_.fail(*tree_.joint_elements.at(joint.name), "joint " + quote(joint.name) + message, hint);
    }
    [[noreturn]] void fail_at_link(const std::string& link, const std::string& message,
                                   const std::string& hint = {}) const {
        xml_.fail(*tree_.link_elements.at(link), "link " + quote(link) + message, hint);
    }

    Pose to_pose(const urdf::Pose& pose) const {
        return pose_from_quaternion(to_vector(pose.position),
                                    {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w});
    }

    double size(const std::string& link, double number, const char* what) const {
        if (number > 0 && std::isfinite(number)) return number;
        fail_at_link(link, " has a " + std::string(what) + " that is not above 0");
    }

    std::shared_ptr<const Mesh> to_mesh(const std::string& link, const urdf::Mesh& mesh) const {
        const std::string file = find_resource(mesh.filename, xml_.source().name, options_.packages);
        if (file.empty()) {
            fail_at_link(link, " has a mesh " + quote(mesh.filename) + " that no package has",
                         "name the directory of its package");
        }
        try {
            return read_mesh(file, to_vector(mesh.scale));
        } catch (const InputError& error) {
            fail_at_link(link, " has a mesh that cannot be used", error.diagnostics().front().message);
        }
    }

    Shape to_shape(const std::string& link, const urdf::Geometry& geometry) const {
        switch (geometry.type) {
            case urdf::Geometry::SPHERE:
                return Sphere{size(link, static_cast<const urdf::Sphere&>(geometry).radius, "radius")};
            case urdf::Geometry::BOX: {
                const Vector3 sides = to_vector(static_cast<const urdf::Box&>(geometry).dim);
                for (const double side : sides) size(link, side, "size of a box");
                return Box{sides};
            }
            case urdf::Geometry::CYLINDER: {
                const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
                return Cylinder{size(link, cylinder.radius, "radius"), size(link, cylinder.length, "length")};
            }
            case urdf::Geometry::MESH:
                return to_mesh(link, static_cast<const urdf::Mesh&>(geometry));
        }
        fail_at_link(link, " has a shape of an unknown kind");
    }

    std::vector<PlacedShape> visual_shapes(const urdf::Link& link) const {
        std::vector<PlacedShape> shapes;
        for (const auto& visual : link.visual_array) {
            try {
                shapes.push_back({to_pose(visual->origin), to_shape(link.name, *visual->geometry)});
            } catch (const InputError&) {
                return {};
            }
        }
        return shapes;
    }

    int add_link(const std::string& name, int parent_joint) {
        const urdf::Link& link = *model_->getLink(name);
        Link made{.name = name, .parent_joint = parent_joint};
        for (const auto& collision : link.collision_array) {
            made.collision.push_back({to_pose(collision->origin), to_shape(name, *collision->geometry)});
        }
        merge_capsules(made.collision);
        if (options_.visuals) made.visual = visual_shapes(link);
        robot_.links.push_back(std::move(made));
        return static_cast<int>(robot_.links.size()) - 1;
    }

    /// Appends a joint whose child is the next link.
    Joint& append_joint(const std::string& name, JointType type, int parent, const Pose& origin,
                        const Vector3& axis) {
        robot_.joints.push_back({.name = name,
                                 .type = type,
                                 .parent = parent,
                                 .child = static_cast<int>(robot_.links.size()),
                                 .origin = origin,
                                 .axis = axis});
        return robot_.joints.back();
    }

    void add_joint(const urdf::Joint& joint) {
        const int parent = robot_.find_link(joint.parent_link_name);
        const Pose origin = to_pose(joint.parent_to_joint_origin_transform);
        switch (joint.type) {
            case urdf::Joint::FIXED:
                append_joint(joint.name, JointType::fixed, parent, origin, Vector3::UnitZ());
                break;
            case urdf::Joint::REVOLUTE:
                add_moving_joint(joint, JointType::revolute, parent, origin);
                break;
            case urdf::Joint::CONTINUOUS:
                add_moving_joint(joint, JointType::continuous, parent, origin);
                break;
            case urdf::Joint::PRISMATIC:
                add_moving_joint(joint, JointType::prismatic, parent, origin);
                break;
            case urdf::Joint::PLANAR:
                add_planar_joint(joint, parent, origin);
                break;
            default:
                fail_at_joint(joint, " floats, which is not supported", "make it fixed or planar");
        }
        add_link(joint.child_link_name, static_cast<int>(robot_.joints.size()) - 1);
    }

    Vector3 unit_axis(const urdf::Joint& joint) const {
        const Vector3 axis = to_vector(joint.axis);
        if (!(axis.norm() > 1e-9)) fail_at_joint(joint, " has an axis of length zero");
        return axis.normalized();
    }

    int add_variable(const urdf::Joint& joint, const std::string& name, JointType type) {
        Variable variable{.name = name, .continuous = type == JointType::continuous};
        variable.max_velocity = kDefaultVelocity;
        if (joint.limits) {
            if (joint.limits->velocity < 0) fail_at_joint(joint, " has a limit of velocity below 0");
            if (joint.limits->velocity > 0) variable.max_velocity = joint.limits->velocity;
        }
        variable.max_acceleration = variable.max_velocity / kDefaultAccelerationTime;
        robot_.variables.push_back(variable);
        return static_cast<int>(robot_.variables.size()) - 1;
    }

    void limit(Variable& variable, const urdf::Joint& joint) const {
        variable.lower = joint.limits->lower;
        variable.upper = joint.limits->upper;
        if (joint.safety && joint.safety->soft_lower_limit < joint.safety->soft_upper_limit) {
            variable.lower = std::max(variable.lower, joint.safety->soft_lower_limit);
            variable.upper = std::min(variable.upper, joint.safety->soft_upper_limit);
        }
        if (variable.lower > variable.upper) {
            fail_at_joint(joint, " has a lower limit above its upper one", "exchange them");
        }
    }

    void add_moving_joint(const urdf::Joint& joint, JointType type, int parent, const Pose& origin) {
        Joint& made = append_joint(joint.name, type, parent, origin, unit_axis(joint));
        if (joint.mimic) return;
        made.variable = add_variable(joint, joint.name, type);
        if (type != JointType::continuous) limit(robot_.variables.back(), joint);
    }

    void add_planar_joint(const urdf::Joint& joint, int parent, const Pose& origin) {
        if (joint.mimic) fail_at_joint(joint, " is planar and cannot mimic another one");
        const Vector3 normal = unit_axis(joint);
        const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), normal);
        const auto slide = [&](const char* suffix, int from, const Pose& at, const Vector3& axis) {
            const std::string name = joint.name + suffix;
            append_joint(name, JointType::prismatic, from, at, axis).variable =
                add_variable(joint, name, JointType::prismatic);
            robot_.links.push_back({.name = joint.child_link_name + suffix,
                                    .parent_joint = static_cast<int>(robot_.joints.size()) - 1});
            return static_cast<int>(robot_.links.size()) - 1;
        };
        const int x = slide("/x", parent, origin, turn * Vector3::UnitX());
        const int y = slide("/y", x, Pose::Identity(), turn * Vector3::UnitY());
        const std::string name = joint.name + "/theta";
        append_joint(name, JointType::continuous, y, Pose::Identity(), normal).variable =
            add_variable(joint, name, JointType::continuous);
    }

    Joint& made_joint(const std::string& name) {
        return *std::ranges::find(robot_.joints, name, &Joint::name);
    }

    /// Follows masters until one has a variable.
    void resolve_mimic(const urdf::Joint& joint) {
        if (!joint.mimic || joint.type == urdf::Joint::FIXED) return;
        double multiplier = 1;
        double offset = 0;
        const urdf::Joint* master = &joint;
        for (std::size_t steps = 0; master->mimic; ++steps) {
            if (steps > tree_.joints.size())
                fail_at_joint(joint, " mimics itself", "give one joint no <mimic>");
            offset += multiplier * master->mimic->offset;
            multiplier *= master->mimic->multiplier;
            const auto next = model_->getJoint(master->mimic->joint_name);
            if (!next) {
                fail_at_joint(joint, " mimics an unknown joint " + quote(master->mimic->joint_name),
                              "name one of the file");
            }
            master = next.get();
        }
        if (master->type == urdf::Joint::FIXED || master->type == urdf::Joint::PLANAR) {
            fail_at_joint(joint, " mimics " + quote(master->name) + ", which has no single variable");
        }
        Joint& made = made_joint(joint.name);
        made.variable = made_joint(master->name).variable;
        made.multiplier = multiplier;
        made.offset = offset;
    }

    const XmlFile& xml_;
    const RobotOptions& options_;
    UrdfTree tree_;
    urdf::ModelInterfaceSharedPtr model_;
    Robot robot_;
};

}  // namespace

Robot parse_urdf(const Source& source, const RobotOptions& options) {
    const XmlFile xml(source, "robot");
    Robot robot = UrdfReader(xml, options).read();
    apply_limits(robot, options.limits, source.name);
    allow_neighbours(robot);
    require_valid(robot, source.name);
    cover_links(robot, options.cover);
    return robot;
}

Robot read_urdf(const std::string& file, const RobotOptions& options) {
    return parse_urdf(read_source(file), options);
}

}  // namespace praxis::tamp
