#include "tamp/robots/description.hpp"

#include <algorithm>
#include <stdexcept>

#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/robots/derive.hpp"
#include "tamp/robots/dh.hpp"
#include "tamp/robots/finish_robot.hpp"
#include "tamp/text/yaml_document.hpp"

namespace praxis::tamp {

namespace {

class DescriptionReader {
  public:
    DescriptionReader(const YamlDocument& yaml, const RobotOptions& options)
        : yaml_(yaml), options_(options) {}

    Robot read() {
        const YAML::Node root = yaml_.root();
        yaml_.require_keys(root, "the robot",
                           {"robot", "convention", "base", "rows", "groups", "states", "end_effectors",
                            "allowed_collisions"});
        const DhTable table = read_table(root);
        try {
            robot_ = make_dh_robot(table, options_.cover);
        } catch (const std::invalid_argument& error) {
            yaml_.fail(root["rows"], error.what());
        }
        for (const auto& group : list(root, "groups")) read_group(group);
        if (robot_.groups.empty()) derive_groups(robot_);
        for (const auto& state : list(root, "states")) read_state(state);
        for (const auto& effector : list(root, "end_effectors")) read_end_effector(effector);
        const bool told = YamlDocument::find(root, "allowed_collisions").IsDefined();
        for (const auto& pair : list(root, "allowed_collisions")) read_pair(pair);
        apply_limits(robot_, options_.limits, yaml_.name());
        allow_neighbours(robot_);
        if (!told) derive_allowed_collisions(robot_, options_.samples, options_.seed);
        require_valid(robot_, yaml_.name());
        return std::move(robot_);
    }

  private:
    /// An optional list: empty if it is not there.
    YAML::Node list(const YAML::Node& map, const char* key) const {
        const YAML::Node found = YamlDocument::find(map, key);
        if (!is_given(found)) return YAML::Node(YAML::NodeType::Sequence);
        yaml_.require_list(found, quote(key));
        return found;
    }

    double number_or(const YAML::Node& map, const char* key, double otherwise) const {
        const YAML::Node found = YamlDocument::find(map, key);
        return found.IsDefined() ? yaml_.number(found, quote(key)) : otherwise;
    }

    std::string text_or(const YAML::Node& map, const char* key, const char* otherwise) const {
        const YAML::Node found = YamlDocument::find(map, key);
        return found.IsDefined() ? yaml_.text(found, quote(key)) : otherwise;
    }

    std::string name(const YAML::Node& map, const char* key, const std::string& what) const {
        return yaml_.text(yaml_.member(map, key, what), quote(key));
    }

    double length(const YAML::Node& map, const char* key, const std::string& what) const {
        return yaml_.length(yaml_.member(map, key, what), "the " + std::string(key) + " of " + what);
    }

    Vector3 vector_or_zero(const YAML::Node& map, const char* key) const {
        const YAML::Node found = YamlDocument::find(map, key);
        return found.IsDefined() ? yaml_.vector(found, quote(key)) : Vector3(0, 0, 0);
    }

    Pose pose(const YAML::Node& map) const {
        return pose_from_rpy(vector_or_zero(map, "xyz"), vector_or_zero(map, "rpy"));
    }

    /// A cylinder or capsule, by its length and pose or by its ends.
    template <class Long>
    PlacedShape read_long(const YAML::Node& sizes, const std::string& what) const {
        yaml_.require_map(sizes, what);
        const double radius = length(sizes, "radius", what);
        if (!sizes["from"] && !sizes["to"]) {
            yaml_.require_keys(sizes, what, {"radius", "length", "xyz", "rpy"});
            return {pose(sizes), Long{radius, length(sizes, "length", what)}};
        }
        yaml_.require_keys(sizes, what, {"radius", "from", "to"});
        const Vector3 from = yaml_.vector(yaml_.member(sizes, "from", what), "'from'");
        const Vector3 to = yaml_.vector(yaml_.member(sizes, "to", what), "'to'");
        if (!((to - from).norm() > 0)) yaml_.fail(sizes, "the ends of " + what + " must differ");
        Pose placed = Pose::Identity();
        placed.translation() = (from + to) / 2;
        placed.linear() =
            Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), Vector3(to - from)).toRotationMatrix();
        return {placed, Long{radius, (to - from).norm()}};
    }

    PlacedShape read_shape(const YAML::Node& node) const {
        yaml_.require_keys(node, "a shape", {"sphere", "box", "cylinder", "capsule"});
        if (node.size() != 1) yaml_.fail(node, "a shape is one of sphere, box, cylinder and capsule");
        if (const YAML::Node sizes = node["sphere"]) {
            yaml_.require_keys(sizes, "a sphere", {"radius", "xyz", "rpy"});
            return {pose(sizes), Sphere{length(sizes, "radius", "a sphere")}};
        }
        if (const YAML::Node sizes = node["box"]) {
            yaml_.require_keys(sizes, "a box", {"size", "xyz", "rpy"});
            const YAML::Node size = yaml_.member(sizes, "size", "a box");
            const Vector3 sides = yaml_.vector(size, "the size of a box");
            if (!(sides.minCoeff() > 0)) yaml_.fail(size, "the sides of a box must be above 0");
            return {pose(sizes), Box{sides}};
        }
        if (const YAML::Node sizes = node["cylinder"]) return read_long<Cylinder>(sizes, "a cylinder");
        return read_long<Capsule>(node["capsule"], "a capsule");
    }

    std::vector<PlacedShape> read_shapes(const YAML::Node& map) const {
        std::vector<PlacedShape> shapes;
        for (const auto& shape : list(map, "shapes")) shapes.push_back(read_shape(shape));
        return shapes;
    }

    template <class Value>
    Value word(const YAML::Node& node, const std::string& what,
               std::initializer_list<std::pair<const char*, Value>> values) const {
        const std::string written = yaml_.text(node, what);
        std::string known;
        for (const auto& [name, value] : values) {
            if (written == name) return value;
            known += (known.empty() ? "" : ", ") + std::string(name);
        }
        yaml_.fail(node, what + " cannot be " + quote(written), "known are " + known);
    }

    void read_limits(const YAML::Node& node, const std::string& what, DhRow& row) const {
        if (row.type == JointType::revolute || row.type == JointType::prismatic) {
            const YAML::Node limits = yaml_.member(node, "limits", what);
            const std::vector<double> range = yaml_.numbers(limits, "the limits of " + what, 2);
            if (range[0] > range[1]) yaml_.fail(limits, what + " has a lower limit above its upper one");
            row.limits.lower = range[0];
            row.limits.upper = range[1];
        }
        row.limits.max_velocity = node["velocity"] ? length(node, "velocity", what) : kDefaultVelocity;
        row.limits.max_acceleration = node["acceleration"]
                                          ? length(node, "acceleration", what)
                                          : row.limits.max_velocity / kDefaultAccelerationTime;
    }

    DhRow read_row(const YAML::Node& node) const {
        yaml_.require_keys(node, "a row",
                           {"joint", "link", "parent", "type", "a", "alpha", "d", "theta", "limits",
                            "velocity", "acceleration", "mimic", "shapes"});
        DhRow row{.joint = name(node, "joint", "a row"),
                  .link = name(node, "link", "a row"),
                  .parent = text_or(node, "parent", "")};
        const std::string what = "joint " + quote(row.joint);
        if (const YAML::Node type = node["type"]) {
            row.type = word<JointType>(type, "the type of " + what,
                                       {{"revolute", JointType::revolute},
                                        {"continuous", JointType::continuous},
                                        {"prismatic", JointType::prismatic},
                                        {"fixed", JointType::fixed}});
        }
        row.a = number_or(node, "a", 0);
        row.alpha = number_or(node, "alpha", 0);
        row.d = number_or(node, "d", 0);
        row.theta = number_or(node, "theta", 0);
        row.shapes = read_shapes(node);
        if (const YAML::Node mimic = node["mimic"]) {
            yaml_.require_keys(mimic, "'mimic'", {"joint", "multiplier", "offset"});
            row.mimic = name(mimic, "joint", "'mimic'");
            row.multiplier = number_or(mimic, "multiplier", 1);
            row.offset = number_or(mimic, "offset", 0);
        } else {
            read_limits(node, what, row);
        }
        return row;
    }

    DhTable read_table(const YAML::Node& root) const {
        DhTable table{.name = name(root, "robot", "the file")};
        if (const YAML::Node convention = root["convention"]) {
            table.convention = word<DhConvention>(
                convention, "the convention",
                {{"standard", DhConvention::standard}, {"modified", DhConvention::modified}});
        }
        if (const YAML::Node base = root["base"]) {
            yaml_.require_keys(base, "'base'", {"link", "shapes"});
            table.root = text_or(base, "link", "base");
            table.root_shapes = read_shapes(base);
        }
        yaml_.member(root, "rows", "the robot");
        for (const auto& row : list(root, "rows")) table.rows.push_back(read_row(row));
        return table;
    }

    template <class Items>
    [[noreturn]] void fail_unknown(const YAML::Node& node, const char* kind, const Items& items) const {
        const std::string wrong = yaml_.text(node, "a name");
        Suggestion suggestion(wrong);
        for (const auto& item : items) suggestion.consider(item.name);
        yaml_.fail(node, "unknown " + std::string(kind) + ' ' + quote(wrong), suggestion.hint());
    }

    int link(const YAML::Node& node) const {
        const int found = robot_.find_link(yaml_.text(node, "the name of a link"));
        if (found < 0) fail_unknown(node, "link", robot_.links);
        return found;
    }

    const Group& group(const YAML::Node& node) const {
        const int found = robot_.find_group(yaml_.text(node, "the name of a group"));
        if (found < 0) fail_unknown(node, "group", robot_.groups);
        return robot_.groups[static_cast<std::size_t>(found)];
    }

    void read_group(const YAML::Node& node) {
        yaml_.require_keys(node, "a group", {"name", "joints", "tip"});
        Group made{.name = name(node, "name", "a group")};
        if (robot_.find_group(made.name) >= 0) yaml_.fail(node, "there is another group " + quote(made.name));
        yaml_.member(node, "joints", "a group");
        for (const auto& joint : list(node, "joints")) {
            const int variable = robot_.find_variable(yaml_.text(joint, "the name of a joint"));
            if (variable < 0) fail_unknown(joint, "moving joint", robot_.variables);
            made.variables.push_back(variable);
        }
        std::ranges::sort(made.variables);
        if (const YAML::Node tip = node["tip"]) made.tip = link(tip);
        robot_.groups.push_back(std::move(made));
    }

    Configuration positions(const YAML::Node& node, const Group& of) const {
        Configuration numbers =
            yaml_.numbers(node, "positions of group " + quote(of.name), of.variables.size());
        if (!robot_.within_limits(of, numbers)) yaml_.fail(node, "the positions are outside of the limits");
        return numbers;
    }

    void read_state(const YAML::Node& node) {
        yaml_.require_keys(node, "a state", {"name", "group", "positions"});
        const Group& of = group(yaml_.member(node, "group", "a state"));
        robot_.states.push_back({name(node, "name", "a state"), of.name,
                                 positions(yaml_.member(node, "positions", "a state"), of)});
    }

    void read_end_effector(const YAML::Node& node) {
        const std::string what = "an end effector";
        yaml_.require_keys(
            node, what, {"name", "link", "arm", "gripper", "tool", "links", "max_opening", "open", "closed"});
        EndEffector made{.name = name(node, "name", what),
                         .link = link(yaml_.member(node, "link", what)),
                         .arm = group(yaml_.member(node, "arm", what)).name};
        if (robot_.find_end_effector(made.name) >= 0) {
            yaml_.fail(node, "there is another end effector " + quote(made.name));
        }
        if (const YAML::Node tool = node["tool"]) {
            yaml_.require_keys(tool, "'tool'", {"xyz", "rpy"});
            made.tool = pose(tool);
        }
        made.links = {made.link};
        for (const auto& part : list(node, "links")) made.links.push_back(link(part));
        std::ranges::sort(made.links);
        made.links.erase(std::unique(made.links.begin(), made.links.end()), made.links.end());
        made.max_opening = number_or(node, "max_opening", 0);
        if (const YAML::Node gripper = node["gripper"]) {
            const Group& fingers = group(gripper);
            made.gripper = fingers.name;
            if (const YAML::Node open = node["open"]) made.open = positions(open, fingers);
            if (const YAML::Node closed = node["closed"]) made.closed = positions(closed, fingers);
        }
        robot_.end_effectors.push_back(std::move(made));
    }

    void read_pair(const YAML::Node& node) {
        yaml_.require_list(node, "an allowed collision");
        if (node.size() != 2) yaml_.fail(node, "an allowed collision is a pair of links");
        const int first = link(node[0]);
        const int second = link(node[1]);
        if (first == second) yaml_.fail(node, "a link never collides with itself");
        robot_.allowed_collisions.emplace_back(std::min(first, second), std::max(first, second));
    }

    const YamlDocument& yaml_;
    const RobotOptions& options_;
    Robot robot_;
};

}  // namespace

Robot parse_description(const Source& source, const RobotOptions& options) {
    const YamlDocument yaml(source);
    return DescriptionReader(yaml, options).read();
}

Robot read_description(const std::string& file, const RobotOptions& options) {
    return parse_description(read_source(file), options);
}

}  // namespace praxis::tamp
