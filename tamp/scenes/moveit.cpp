#include "tamp/scenes/moveit.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "parser/suggest.hpp"
#include "tamp/scenes/allow_collision.hpp"
#include "tamp/scenes/body.hpp"
#include "tamp/text/yaml_document.hpp"

namespace praxis::tamp {

namespace {

/// As a list, or as a map with these keys.
std::vector<double> coordinates(const YamlDocument& file, const YAML::Node& node, const std::string& what,
                                const std::vector<const char*>& keys) {
    if (!node.IsMap()) return file.numbers(node, what, keys.size());
    std::vector<double> values;
    values.reserve(keys.size());
    for (const char* key : keys) values.push_back(file.number(file.member(node, key, what), what));
    return values;
}

Vector3 read_vector(const YamlDocument& file, const YAML::Node& node, const std::string& what) {
    const std::vector<double> values = coordinates(file, node, what, {"x", "y", "z"});
    return {values[0], values[1], values[2]};
}

Pose read_pose(const YamlDocument& file, const YAML::Node& node, const std::string& what,
               const char* position, const char* orientation) {
    const Vector3 place = read_vector(file, file.member(node, position, what), what);
    const YAML::Node turn = file.member(node, orientation, what);
    const std::vector<double> q = coordinates(file, turn, what, {"x", "y", "z", "w"});
    try {
        return pose_from_quaternion(place, {q[0], q[1], q[2], q[3]});
    } catch (const std::invalid_argument& error) {
        file.fail(turn, what + ": " + error.what());
    }
}

class SceneReader {
  public:
    SceneReader(const YamlDocument& file, Robot& robot) : file_(file), robot_(robot) {}

    World read_world() {
        World world;
        const YAML::Node part = file_.member(file_.root(), "world", "the scene");
        const YAML::Node map = YamlDocument::find(part, "octomap");
        if (is_given(YamlDocument::find(YamlDocument::find(map, "octomap"), "data"))) {
            file_.fail(map, "octomaps inside of MoveIt scenes are not read",
                       "give it as a file to a body of a Praxis scene");
        }
        const YAML::Node objects = YamlDocument::find(part, "collision_objects");
        if (is_given(objects)) {
            file_.require_list(objects, "collision_objects");
            for (const YAML::Node& object : objects) world = with_object(world, object);
        }
        return with_matrix(std::move(world));
    }

  private:
    World with_object(const World& world, const YAML::Node& node) const {
        const std::string name =
            file_.text(file_.member(node, "id", "a collision object"), "the id of a collision object");
        const std::string what = "collision object " + quote(name);
        if (world.find(name) >= 0) file_.fail(node, what + " is there already");
        if (is_given(YamlDocument::find(node, "planes")))
            file_.fail(node["planes"], what + ": planes are not read", "use a box");
        std::vector<PlacedShape> shapes;
        add_shapes(node, "primitives", "primitive_poses", what, shapes);
        add_shapes(node, "meshes", "mesh_poses", what, shapes);
        if (shapes.empty()) file_.fail(node, what + " has no shape");
        Pose pose = frame(node, what);
        if (is_given(YamlDocument::find(node, "pose"))) {
            pose = pose * read_pose(file_, node["pose"], what, "position", "orientation");
        } else {
            const Pose first = shapes.front().pose;
            for (PlacedShape& shape : shapes) shape.pose = first.inverse() * shape.pose;
            shapes.front().pose = Pose::Identity();
            pose = pose * first;
        }
        return world.with_body(make_body(name, std::move(shapes)), pose);
    }

    Pose frame(const YAML::Node& object, const std::string& what) const {
        const YAML::Node frame_id = YamlDocument::find(YamlDocument::find(object, "header"), "frame_id");
        if (!is_given(frame_id)) return Pose::Identity();
        const std::string& id = frame_id.Scalar();
        if (id.empty() || id == "world") return Pose::Identity();
        if (id == robot_.links[0].name) return robot_.base;
        file_.fail(frame_id, what + " is given in the frame " + quote(id) + "; only the world and " +
                                 quote(robot_.links[0].name) + " are read");
    }

    void add_shapes(const YAML::Node& object, const char* key, const char* poses_key, const std::string& what,
                    std::vector<PlacedShape>& shapes) const {
        const YAML::Node list = YamlDocument::find(object, key);
        if (!is_given(list)) return;
        const YAML::Node poses = file_.member(object, poses_key, what);
        file_.require_list(list, what + ": " + key);
        file_.require_list(poses, what + ": " + poses_key);
        if (poses.size() != list.size()) {
            file_.fail(poses, what + " has " + std::to_string(list.size()) + " " + key + " but " +
                                  std::to_string(poses.size()) + " poses of them");
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Pose pose = read_pose(file_, poses[i], what, "position", "orientation");
            shapes.push_back(
                {pose, key == std::string_view("meshes") ? mesh(list[i], what) : primitive(list[i], what)});
        }
    }

    Shape primitive(const YAML::Node& node, const std::string& what) const {
        const YAML::Node kind = file_.member(node, "type", what);
        const YAML::Node sizes = file_.member(node, "dimensions", what);
        const std::string& type = kind.Scalar();
        const auto lengths = [&](std::size_t count) {
            std::vector<double> values = file_.numbers(sizes, what + ": dimensions", count);
            for (const YAML::Node& size : sizes) file_.length(size, what + ": a dimension");
            return values;
        };
        if (type == "box" || type == "1") {
            const std::vector<double> size = lengths(3);
            return Box{{size[0], size[1], size[2]}};
        }
        if (type == "sphere" || type == "2") return Sphere{lengths(1)[0]};
        if (type == "cylinder" || type == "3") {
            const std::vector<double> size = lengths(2);
            return Cylinder{.radius = size[1], .length = size[0]};
        }
        file_.fail(kind, what + " has a primitive of kind " + quote(type),
                   "read are box, sphere and cylinder; make it a mesh");
    }

    Shape mesh(const YAML::Node& node, const std::string& what) const {
        Mesh mesh;
        mesh.name = file_.name();
        const YAML::Node vertices = file_.member(node, "vertices", what + ": a mesh");
        const YAML::Node triangles = file_.member(node, "triangles", what + ": a mesh");
        file_.require_list(vertices, what + ": vertices");
        file_.require_list(triangles, what + ": triangles");
        for (const YAML::Node& vertex : vertices) {
            mesh.vertices.push_back(read_vector(file_, vertex, what + ": a vertex"));
        }
        for (const YAML::Node& triangle : triangles) {
            const YAML::Node corners =
                triangle.IsMap() ? file_.member(triangle, "vertex_indices", what + ": a triangle") : triangle;
            const std::vector<double> indices = file_.numbers(corners, what + ": a triangle", 3);
            std::array<std::uint32_t, 3> corner = {};
            for (std::size_t i = 0; i < 3; ++i) {
                if (!(indices[i] >= 0 && indices[i] < static_cast<double>(mesh.vertices.size()))) {
                    file_.fail(corners, what + " has a triangle with a vertex that is not there");
                }
                corner[i] = static_cast<std::uint32_t>(indices[i]);
            }
            mesh.triangles.push_back(corner);
        }
        if (mesh.triangles.empty()) file_.fail(node, what + " has a mesh without triangles");
        return std::make_shared<const Mesh>(std::move(mesh));
    }

    World with_matrix(World world) const {
        const YAML::Node matrix = YamlDocument::find(file_.root(), "allowed_collision_matrix");
        if (!is_given(matrix)) return world;
        const std::string what = "allowed_collision_matrix";
        const YAML::Node list = YamlDocument::find(matrix, "entry_names");
        if (!is_given(list)) return world;
        const std::vector<std::string> names = file_.texts(list, what + ": entry_names");
        const YAML::Node rows = file_.member(matrix, "entry_values", what);
        file_.require_list(rows, what + ": entry_values");
        if (rows.size() != names.size()) file_.fail(rows, what + " must have one row a name");
        std::vector<std::optional<Participant>> participants;
        participants.reserve(names.size());
        for (const std::string& name : names) participants.push_back(find_participant(robot_, world, name));
        for (std::size_t i = 0; i < names.size(); ++i) {
            const YAML::Node row = rows[i].IsMap() ? file_.member(rows[i], "enabled", what) : rows[i];
            file_.require_list(row, what + ": a row");
            if (row.size() != names.size()) file_.fail(row, what + " must have one column a name");
            std::size_t j = 0;
            for (const YAML::Node& entry : row) {
                const bool allowed = file_.boolean(entry, what + ": an entry");
                if (allowed && i != j && participants[i] && participants[j]) {
                    allow_collision(robot_, world, *participants[i], *participants[j]);
                }
                ++j;
            }
        }
        return world;
    }

    const YamlDocument& file_;
    Robot& robot_;
};

/// Number of a variable, or -1 for a joint that does not move; other names are refused.
int find_joint(const YamlDocument& file, const YAML::Node& at, const Robot& robot, const std::string& name) {
    const int variable = robot.find_variable(name);
    if (variable >= 0 || std::ranges::find(robot.joints, name, &Joint::name) != robot.joints.end()) {
        return variable;
    }
    Suggestion suggestion(name);
    for (const Joint& joint : robot.joints) suggestion.consider(joint.name);
    file.fail(at, "robot '" + robot.name + "' has no joint " + quote(name), suggestion.hint());
}

/// Overwrites what the state of a scene or request says. A mimicking joint's own number is skipped.
void read_state(const YamlDocument& file, const char* key, const Robot& robot, Configuration& configuration) {
    const YAML::Node state = YamlDocument::find(file.root(), key);
    if (!is_given(state)) return;
    file.require_map(state, key);
    if (is_given(YamlDocument::find(state, "attached_collision_objects"))) {
        file.fail(state["attached_collision_objects"], "attached objects are not read");
    }
    const YAML::Node bases =
        YamlDocument::find(YamlDocument::find(state, "multi_dof_joint_state"), "transforms");
    if (is_given(bases)) {
        file.require_list(bases, "transforms");
        for (const YAML::Node& base : bases) {
            const Pose pose = read_pose(file, base, "a transform", "translation", "rotation");
            if (!pose.isApprox(Pose::Identity(), 1e-9)) {
                file.fail(base, "joints of several degrees of freedom are not read",
                          "give the base pose to the robot");
            }
        }
    }
    const YAML::Node joints = YamlDocument::find(state, "joint_state");
    if (!is_given(joints)) return;
    const std::string what = std::string(key) + ": joint_state";
    const YAML::Node list = file.member(joints, "name", what);
    const std::vector<std::string> names = file.texts(list, what);
    const std::vector<double> positions =
        file.numbers(file.member(joints, "position", what), what + ": position", names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int variable = find_joint(file, list, robot, names[i]);
        if (variable >= 0) configuration[static_cast<std::size_t>(variable)] = positions[i];
    }
}

using JointGoal = std::map<int, double>;  ///< by variable

JointGoal read_goal(const YamlDocument& file, const YAML::Node& constraints, const Robot& robot) {
    for (const char* key : {"position_constraints", "orientation_constraints", "visibility_constraints"}) {
        const YAML::Node other = YamlDocument::find(constraints, key);
        if (is_given(other)) file.fail(other, "only goals of joints are read", "give joint_constraints");
    }
    JointGoal goal;
    const YAML::Node list = file.member(constraints, "joint_constraints", "a goal");
    file.require_list(list, "joint_constraints");
    for (const YAML::Node& constraint : list) {
        const YAML::Node joint = file.member(constraint, "joint_name", "a joint constraint");
        const std::string name = file.text(joint, "joint_name");
        const double position = file.number(file.member(constraint, "position", "a joint constraint"),
                                            "the position of joint " + quote(name));
        const int variable = find_joint(file, joint, robot, name);
        if (variable >= 0 && !goal.emplace(variable, position).second) {
            file.fail(joint, "the goal names joint " + quote(name) + " twice");
        }
    }
    if (goal.empty()) file.fail(constraints, "the goal names no joint that moves");
    return goal;
}

int require_group(Robot& robot, const std::string& name, const JointGoal& goal) {
    const int found = robot.find_group(name);
    if (found >= 0) return found;
    Group group;
    group.name = name;
    for (const auto& [variable, position] : goal) group.variables.push_back(variable);
    const auto moved = std::ranges::find(robot.joints, group.variables.back(), &Joint::variable);
    group.tip = moved->child;
    robot.groups.push_back(std::move(group));
    return static_cast<int>(robot.groups.size()) - 1;
}

}  // namespace

MoveItProblem read_moveit_problem(const std::shared_ptr<const Robot>& robot, const Source& scene,
                                  const Source& request) {
    const YamlDocument scene_file(scene);
    const YamlDocument request_file(request);
    const auto own_robot = std::make_shared<Robot>(*robot);
    MoveItProblem problem;
    problem.world = std::make_shared<const World>(SceneReader(scene_file, *own_robot).read_world());
    problem.start = robot->zero();
    read_state(scene_file, "robot_state", *robot, problem.start);
    read_state(request_file, "start_state", *robot, problem.start);

    const YAML::Node name = request_file.member(request_file.root(), "group_name", "the request");
    const YAML::Node goals = request_file.member(request_file.root(), "goal_constraints", "the request");
    request_file.require_list(goals, "goal_constraints");
    if (goals.size() == 0) request_file.fail(goals, "the request has no goal");
    std::vector<JointGoal> joint_goals;
    joint_goals.reserve(goals.size());
    for (const YAML::Node& goal : goals) joint_goals.push_back(read_goal(request_file, goal, *robot));
    problem.group =
        require_group(*own_robot, request_file.text(name, "the group's name"), joint_goals.front());
    const Group& group = own_robot->groups[static_cast<std::size_t>(problem.group)];
    for (const JointGoal& goal : joint_goals) {
        Configuration positions;
        for (const int variable : group.variables) {
            const auto found = goal.find(variable);
            if (found == goal.end()) {
                request_file.fail(goals, "the goal says nothing of joint '" +
                                             robot->variables[static_cast<std::size_t>(variable)].name +
                                             "' of group '" + group.name + "'");
            }
            positions.push_back(found->second);
        }
        problem.goals.push_back(std::move(positions));
    }
    check_robot(*own_robot);
    problem.robot = own_robot;
    return problem;
}

}  // namespace praxis::tamp
