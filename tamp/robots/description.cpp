#include "tamp/robots/description.hpp"

#include <algorithm>
#include <stdexcept>

#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/robots/derive.hpp"
#include "tamp/robots/dh.hpp"
#include "tamp/robots/finish_robot.hpp"
#include "tamp/robots/yaml_file.hpp"

namespace praxis::tamp {

namespace {

class DescriptionReader {
  public:
    DescriptionReader(const YamlFile& yaml, const RobotOptions& options) : yaml_(yaml), options_(options) {}

    Robot read() {
        const YAML::Node root = yaml_.root();
        yaml_.require_keys(root, {"robot", "convention", "base", "rows", "groups", "states", "end_effectors",
                                  "allowed_collisions"});
        const DhTable table = read_table(root);
        try {
            robot_ = make_dh_robot(table, options_.cover);
        } catch (const std::invalid_argument& error) {
            yaml_.fail(root["rows"], error.what());
        }
        if (root["groups"]) {
            for (const auto& group : list(root, "groups")) read_group(group);
        } else {
            derive_groups(robot_);
        }
        for (const auto& state : list(root, "states")) read_state(state);
        for (const auto& effector : list(root, "end_effectors")) read_end_effector(effector);
        for (const auto& pair : list(root, "allowed_collisions")) read_pair(pair);
        apply_limits(robot_, options_.limits, yaml_.source().name);
        if (!root["allowed_collisions"]) derive_allowed_collisions(robot_, options_.samples, options_.seed);
        allow_neighbours(robot_);
        require_valid(robot_, yaml_.source().name);
        return std::move(robot_);
    }

  private:
    /// An optional list: empty if it is not there.
    YAML::Node list(const YAML::Node& map, const char* key) const {
        const YAML::Node found = map[key];
        if (!found) return YAML::Node(YAML::NodeType::Sequence);
        yaml_.require_list(found);
        return found;
    }

    double number_or(const YAML::Node& map, const char* key, double otherwise) const {
        const YAML::Node found = map[key];
        return found ? yaml_.number(found) : otherwise;
    }

    std::string text_or(const YAML::Node& map, const char* key, const char* otherwise) const {
        const YAML::Node found = map[key];
        return found ? yaml_.text(found) : otherwise;
    }

    double positive(const YAML::Node& map, const char* key) const {
        const YAML::Node found = yaml_.entry(map, key);
        const double number = yaml_.number(found);
        if (!(number > 0)) yaml_.fail(found, quote(key) + " must be above 0");
        return number;
    }

    Vector3 vector(const YAML::Node& node) const {
        const std::vector<double> numbers = yaml_.numbers(node, 3);
        return {numbers[0], numbers[1], numbers[2]};
    }

    Vector3 vector_or_zero(const YAML::Node& map, const char* key) const {
        const YAML::Node found = map[key];
        return found ? vector(found) : Vector3(0, 0, 0);
    }

    Pose pose(const YAML::Node& map) const {
        return pose_from_rpy(vector_or_zero(map, "xyz"), vector_or_zero(map, "rpy"));
    }

    /// A cylinder or capsule, by its length and pose or by its ends.
    template <class Long>
    PlacedShape read_long(const YAML::Node& sizes) const {
        const double radius = positive(sizes, "radius");
        if (!sizes["from"] && !sizes["to"]) {
            yaml_.require_keys(sizes, {"radius", "length", "xyz", "rpy"});
            return {pose(sizes), Long{radius, positive(sizes, "length")}};
        }
        yaml_.require_keys(sizes, {"radius", "from", "to"});
        const Vector3 from = vector(yaml_.entry(sizes, "from"));
        const Vector3 to = vector(yaml_.entry(sizes, "to"));
        const double length = (to - from).norm();
        if (!(length > 0)) yaml_.fail(sizes, "the ends of a shape must differ");
        Pose placed = Pose::Identity();
        placed.translation() = (from + to) / 2;
        placed.linear() =
            Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), Vector3(to - from)).toRotationMatrix();
        return {placed, Long{radius, length}};
    }

    PlacedShape read_shape(const YAML::Node& node) const {
        yaml_.require_keys(node, {"sphere", "box", "cylinder", "capsule"});
        if (node.size() != 1) yaml_.fail(node, "a shape is one of sphere, box, cylinder and capsule");
        if (const YAML::Node sizes = node["sphere"]) {
            yaml_.require_keys(sizes, {"radius", "xyz", "rpy"});
            return {pose(sizes), Sphere{positive(sizes, "radius")}};
        }
        if (const YAML::Node sizes = node["box"]) {
            yaml_.require_keys(sizes, {"size", "xyz", "rpy"});
            const Vector3 size = vector(yaml_.entry(sizes, "size"));
            if (!(size.minCoeff() > 0)) yaml_.fail(sizes, "the sides of a box must be above 0");
            return {pose(sizes), Box{size}};
        }
        if (const YAML::Node sizes = node["cylinder"]) return read_long<Cylinder>(sizes);
        return read_long<Capsule>(node["capsule"]);
    }

    std::vector<PlacedShape> read_shapes(const YAML::Node& map) const {
        std::vector<PlacedShape> shapes;
        for (const auto& shape : list(map, "shapes")) shapes.push_back(read_shape(shape));
        return shapes;
    }

    template <class Value>
    Value word(const YAML::Node& node, std::initializer_list<std::pair<const char*, Value>> values) const {
        const std::string written = yaml_.text(node);
        std::string known;
        for (const auto& [name, value] : values) {
            if (written == name) return value;
            known += (known.empty() ? "" : ", ") + std::string(name);
        }
        yaml_.fail(node, quote(written) + " is none of " + known);
    }

    DhRow read_row(const YAML::Node& node) const {
        yaml_.require_keys(node, {"joint", "link", "parent", "type", "a", "alpha", "d", "theta", "limits",
                                  "velocity", "acceleration", "mimic", "shapes"});
        DhRow row{.joint = yaml_.text(yaml_.entry(node, "joint")),
                  .link = yaml_.text(yaml_.entry(node, "link")),
                  .parent = text_or(node, "parent", "")};
        if (const YAML::Node type = node["type"]) {
            row.type = word<JointType>(type, {{"revolute", JointType::revolute},
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
            yaml_.require_keys(mimic, {"joint", "multiplier", "offset"});
            row.mimic = yaml_.text(yaml_.entry(mimic, "joint"));
            row.multiplier = number_or(mimic, "multiplier", 1);
            row.offset = number_or(mimic, "offset", 0);
        } else if (row.type == JointType::revolute || row.type == JointType::prismatic) {
            const YAML::Node limits = yaml_.entry(node, "limits");
            const std::vector<double> range = yaml_.numbers(limits, 2);
            if (range[0] > range[1]) yaml_.fail(limits, "the lower limit is above the upper one");
            row.limits.lower = range[0];
            row.limits.upper = range[1];
        }
        row.limits.max_velocity = node["velocity"] ? positive(node, "velocity") : kDefaultVelocity;
        row.limits.max_acceleration = node["acceleration"]
                                          ? positive(node, "acceleration")
                                          : row.limits.max_velocity / kDefaultAccelerationTime;
        return row;
    }

    DhTable read_table(const YAML::Node& root) const {
        DhTable table{.name = yaml_.text(yaml_.entry(root, "robot"))};
        if (const YAML::Node convention = root["convention"]) {
            table.convention = word<DhConvention>(
                convention, {{"standard", DhConvention::standard}, {"modified", DhConvention::modified}});
        }
        if (const YAML::Node base = root["base"]) {
            yaml_.require_keys(base, {"link", "shapes"});
            table.root = text_or(base, "link", "base");
            table.root_shapes = read_shapes(base);
        }
        yaml_.entry(root, "rows");
        for (const auto& row : list(root, "rows")) table.rows.push_back(read_row(row));
        return table;
    }

    template <class Items>
    [[noreturn]] void fail_unknown(const YAML::Node& node, const char* kind, const Items& items) const {
        Suggestion suggestion(yaml_.text(node));
        for (const auto& item : items) suggestion.consider(item.name);
        yaml_.fail(node, "unknown " + std::string(kind) + ' ' + quote(yaml_.text(node)) +
                             (suggestion.found() ? "; " + suggestion.hint() : ""));
    }

    int link(const YAML::Node& node) const {
        const int found = robot_.find_link(yaml_.text(node));
        if (found < 0) fail_unknown(node, "link", robot_.links);
        return found;
    }

    const Group& group(const YAML::Node& node) const {
        const int found = robot_.find_group(yaml_.text(node));
        if (found < 0) fail_unknown(node, "group", robot_.groups);
        return robot_.groups[static_cast<std::size_t>(found)];
    }

    void read_group(const YAML::Node& node) {
        yaml_.require_keys(node, {"name", "joints", "tip"});
        Group made{.name = yaml_.text(yaml_.entry(node, "name"))};
        if (robot_.find_group(made.name) >= 0) yaml_.fail(node, "there is another group " + quote(made.name));
        yaml_.entry(node, "joints");
        for (const auto& joint : list(node, "joints")) {
            const int variable = robot_.find_variable(yaml_.text(joint));
            if (variable < 0) fail_unknown(joint, "joint with a variable of its own", robot_.variables);
            made.variables.push_back(variable);
        }
        std::ranges::sort(made.variables);
        if (const YAML::Node tip = node["tip"]) made.tip = link(tip);
        robot_.groups.push_back(std::move(made));
    }

    Configuration positions(const YAML::Node& node, const Group& of) const {
        Configuration numbers = yaml_.numbers(node, of.variables.size());
        if (!robot_.within_limits(of, numbers)) yaml_.fail(node, "the positions are outside of the limits");
        return numbers;
    }

    void read_state(const YAML::Node& node) {
        yaml_.require_keys(node, {"name", "group", "positions"});
        const Group& of = group(yaml_.entry(node, "group"));
        robot_.states.push_back(
            {yaml_.text(yaml_.entry(node, "name")), of.name, positions(yaml_.entry(node, "positions"), of)});
    }

    void read_end_effector(const YAML::Node& node) {
        yaml_.require_keys(
            node, {"name", "link", "arm", "gripper", "tool", "links", "max_opening", "open", "closed"});
        EndEffector made{.name = yaml_.text(yaml_.entry(node, "name")),
                         .link = link(yaml_.entry(node, "link")),
                         .arm = group(yaml_.entry(node, "arm")).name};
        if (robot_.find_end_effector(made.name) >= 0) {
            yaml_.fail(node, "there is another end effector " + quote(made.name));
        }
        if (const YAML::Node tool = node["tool"]) {
            yaml_.require_keys(tool, {"xyz", "rpy"});
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
        yaml_.require_list(node);
        if (node.size() != 2) yaml_.fail(node, "expected a pair of links");
        const int first = link(node[0]);
        const int second = link(node[1]);
        if (first == second) yaml_.fail(node, "a link never collides with itself");
        robot_.allowed_collisions.emplace_back(std::min(first, second), std::max(first, second));
    }

    const YamlFile& yaml_;
    const RobotOptions& options_;
    Robot robot_;
};

}  // namespace

Robot parse_description(const Source& source, const RobotOptions& options) {
    const YamlFile yaml(source);
    return DescriptionReader(yaml, options).read();
}

Robot read_description(const std::string& file, const RobotOptions& options) {
    return parse_description(read_source(file), options);
}

}  // namespace praxis::tamp
