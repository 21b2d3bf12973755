#include "tamp/scenes/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/robots/read_robot.hpp"
#include "tamp/scenes/allow_collision.hpp"
#include "tamp/scenes/body.hpp"
#include "tamp/scenes/scene_shapes.hpp"

namespace praxis::tamp {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostItems = 2'000;

/// PDDL does not tell small letters from capital ones.
std::string folded(std::string name) {
    std::ranges::transform(name, name.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return name;
}

template <class Items>
std::string suggest(std::string_view wrong, const Items& names) {
    Suggestion suggestion(wrong);
    for (const auto& name : names) suggestion.consider(name);
    return suggestion.hint();
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& items) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const T& item : items) names.push_back(item.name);
    return names;
}

class SceneReader {
  public:
    SceneReader(const YamlDocument& file, fs::path folder) : file_(file), folder_(std::move(folder)) {}

    Scene read() {
        const YAML::Node root = file_.root();
        file_.require_keys(
            root, "a scene",
            {"robot", "bodies", "surfaces", "regions", "poses", "allowed_collisions", "gravity", "stream_options"});
        read_robot_part(file_.member(root, "robot", "a scene"));
        each(root, "bodies", [&](const YAML::Node& node) { add_body(node); });
        each(root, "surfaces", [&](const YAML::Node& node) { add_surface(node); });
        scene_.robot = std::make_shared<const Robot>(robot_);
        scene_.world = std::make_shared<const World>(world_);
        each(root, "bodies", [&](const YAML::Node& node) { place_body(node); });
        each(root, "regions", [&](const YAML::Node& node) { add_region(node); });
        each(root, "poses", [&](const YAML::Node& node) { add_pose(node); });
        each(root, "allowed_collisions", [&](const YAML::Node& node) { add_allowed(node); });
        const YAML::Node gravity = YamlDocument::find(root, "gravity");
        if (is_given(gravity)) scene_.gravity = file_.vector(gravity, "gravity");
        read_stream_options(YamlDocument::find(root, "stream_options"));
        scene_.robot = std::make_shared<const Robot>(std::move(robot_));
        scene_.world = std::make_shared<const World>(std::move(world_));
        return std::move(scene_);
    }

  private:
    template <class Read>
    void each(const YAML::Node& root, const char* key, Read&& read) const {
        const YAML::Node list = YamlDocument::find(root, key);
        if (!is_given(list)) return;
        file_.require_list(list, key);
        if (list.size() > kMostItems) file_.fail(list, std::string(key) + " may have 2000 entries at most");
        for (const YAML::Node& node : list) read(node);
    }

    std::optional<YAML::Node> optional(const YAML::Node& node, const char* key) const {
        const YAML::Node found = YamlDocument::find(node, key);
        if (!is_given(found)) return std::nullopt;
        return found;
    }

    std::string name_of(const YAML::Node& node, const std::string& what) const {
        return file_.text(file_.member(node, "name", what), "the name of " + what);
    }

    double yaw_of(const YAML::Node& node, const std::string& what) const {
        const auto yaw = optional(node, "yaw");
        return yaw ? file_.number(*yaw, what + ": yaw") : 0;
    }

    std::array<double, 2> pair_of(const YAML::Node& node, const std::string& what) const {
        const std::vector<double> numbers = file_.numbers(node, what, 2);
        return {numbers[0], numbers[1]};
    }

    std::array<double, 2> size_of(const YAML::Node& node, const std::string& what) const {
        file_.numbers(node, what, 2);
        return {file_.length(node[0], what), file_.length(node[1], what)};
    }

    void read_robot_part(const YAML::Node& node) {
        const std::string what = "the robot";
        file_.require_keys(node, what, {"builtin", "urdf", "srdf", "packages", "base", "start", "joints"});
        const auto builtin = optional(node, "builtin");
        const auto urdf = optional(node, "urdf");
        if (builtin.has_value() == urdf.has_value()) file_.fail(node, what + " needs either builtin or urdf");
        if (builtin) {
            if (optional(node, "srdf")) file_.fail(node, "a robot that is built in needs no srdf");
            robot_ = builtin_part(*builtin);
        } else {
            robot_ = urdf_part(node, *urdf);
        }
        if (const auto base = optional(node, "base")) {
            robot_.base = read_scene_pose(file_, *base, "the robot's base");
        }
        scene_.start = robot_.zero();
        if (const auto start = optional(node, "start")) read_start(*start);
        if (const auto joints = optional(node, "joints")) read_joints(*joints);
    }

    Robot builtin_part(const YAML::Node& node) const {
        const std::string name = file_.text(node, "builtin");
        const std::vector<std::string> names = builtin_robot_names();
        if (std::ranges::find(names, name) == names.end()) {
            std::string list;
            for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
            file_.fail(node, "there is no built-in robot " + quote(name), "there are " + list);
        }
        return builtin_robot(name);
    }

    Robot urdf_part(const YAML::Node& node, const YAML::Node& urdf) const {
        RobotOptions options;
        if (const auto packages = optional(node, "packages")) {
            for (const std::string& package : file_.texts(*packages, "packages")) {
                options.packages.push_back((folder_ / package).string());
            }
        }
        const auto srdf = optional(node, "srdf");
        const std::string urdf_file = (folder_ / file_.text(urdf, "urdf")).string();
        const std::string srdf_file = srdf ? (folder_ / file_.text(*srdf, "srdf")).string() : std::string();
        return read_robot(urdf_file, srdf_file, options);
    }

    /// By group: the name of a state, or positions.
    void read_start(const YAML::Node& node) {
        file_.require_map(node, "the start");
        for (const auto& item : node) {
            const std::string name = file_.text(item.first, "a group of the start");
            const int index = robot_.find_group(name);
            if (index < 0) {
                file_.fail(item.first, "the robot has no group " + quote(name),
                           suggest(name, names_of(robot_.groups)));
            }
            const Group& group = robot_.groups[static_cast<std::size_t>(index)];
            if (item.second.IsScalar()) {
                robot_.insert(group, state_of(group, item.second), scene_.start);
            } else {
                robot_.insert(
                    group,
                    file_.numbers(item.second, "the start of group " + quote(name), group.variables.size()),
                    scene_.start);
            }
        }
    }

    const Configuration& state_of(const Group& group, const YAML::Node& node) const {
        const std::string name = file_.text(node, "a state of the robot");
        std::vector<std::string> known;
        for (const NamedState& state : robot_.states) {
            if (state.group != group.name) continue;
            if (state.name == name) return state.positions;
            known.push_back(state.name);
        }
        file_.fail(node, "group '" + group.name + "' has no state " + quote(name), suggest(name, known));
    }

    void read_joints(const YAML::Node& node) {
        file_.require_map(node, "joints");
        for (const auto& item : node) {
            const std::string name = file_.text(item.first, "a joint");
            const int variable = robot_.find_variable(name);
            if (variable < 0) {
                file_.fail(item.first, "the robot has no variable " + quote(name),
                           suggest(name, names_of(robot_.variables)));
            }
            scene_.start[static_cast<std::size_t>(variable)] =
                file_.number(item.second, "the start of joint " + quote(name));
        }
    }

    /// With its pose, unless that depends on a surface (`place_body`).
    void add_body(const YAML::Node& node) {
        const std::string name = name_of(node, "a body");
        const std::string what = "body " + quote(name);
        file_.require_keys(
            node, what,
            {"name", "pose", "on", "at", "yaw", "attached", "shapes", "box", "sphere", "cylinder", "capsule",
             "mesh", "octomap", "points", "movable", "color", "object", "grasps"});
        if (find_participant(robot_, world_, name)) {
            file_.fail(node, what + ": there is a body or a link of this name already");
        }
        const auto pose = optional(node, "pose");
        const auto on = optional(node, "on");
        const auto attached = optional(node, "attached");
        if ((pose ? 1 : 0) + (on ? 1 : 0) + (attached ? 1 : 0) > 1) {
            file_.fail(node, what + " needs one of pose, on and attached only");
        }
        if (!on && (optional(node, "at") || optional(node, "yaw"))) {
            file_.fail(node, what + " has at or yaw, but not on", "give a pose, or on: SURFACE");
        }
        std::vector<PlacedShape> shapes = read_scene_shapes(file_, node, what, folder_);
        const auto movable_node = optional(node, "movable");
        const bool movable = movable_node && file_.boolean(*movable_node, what + ": movable");
        std::shared_ptr<const BodyModel> model;
        try {
            model = make_body(name, std::move(shapes), movable, color_of(node, what));
        } catch (const std::invalid_argument& error) {
            file_.fail(node, error.what());
        }
        if (movable && model->balls.empty()) file_.fail(node, what + " cannot be movable: it has a map");
        world_ =
            world_.with_body(model, pose ? read_scene_pose(file_, *pose, what + ": pose") : Pose::Identity());
        const int body = static_cast<int>(world_.size()) - 1;
        if (attached) attach(body, *attached, what);
        name_object(node, body, name, what);
        if (const auto grasps = optional(node, "grasps")) scene_.grasps[body] = grasps_of(*grasps, what);
    }

    std::array<float, 3> color_of(const YAML::Node& node, const std::string& what) const {
        const auto color = optional(node, "color");
        if (!color) return BodyModel().color;
        std::array<float, 3> parts = {};
        const std::vector<double> numbers = file_.numbers(*color, what + ": color", 3);
        for (std::size_t i = 0; i < 3; ++i) {
            if (numbers[i] < 0 || numbers[i] > 1)
                file_.fail(*color, what + ": a color is of numbers from 0 to 1");
            parts[i] = static_cast<float>(numbers[i]);
        }
        return parts;
    }

    void attach(int body, const YAML::Node& node, const std::string& what) {
        file_.require_keys(node, what + ": attached", {"link", "pose", "touching"});
        const YAML::Node link_node = file_.member(node, "link", what + ": attached");
        Attachment attachment;
        attachment.link = require_link(link_node, what);
        if (const auto pose = optional(node, "pose")) {
            attachment.in_link = read_scene_pose(file_, *pose, what + ": attached");
        }
        if (const auto touching = optional(node, "touching")) {
            file_.require_list(*touching, what + ": touching");
            for (const YAML::Node& link : *touching) attachment.touching.push_back(require_link(link, what));
        } else {
            for (const EndEffector& effector : robot_.end_effectors) {
                if (effector.link == attachment.link) attachment.touching = effector.links;
            }
        }
        world_ = world_.with_attached(body, attachment);
    }

    int require_link(const YAML::Node& node, const std::string& what) const {
        const std::string name = file_.text(node, what + ": a link");
        const int link = robot_.find_link(name);
        if (link < 0) {
            file_.fail(node, what + ": the robot has no link " + quote(name),
                       suggest(name, names_of(robot_.links)));
        }
        return link;
    }

    void name_object(const YAML::Node& node, int body, const std::string& name, const std::string& what) {
        const auto object = optional(node, "object");
        const std::string word = folded(object ? file_.text(*object, what + ": object") : name);
        const auto [other, is_new] = scene_.objects.emplace(word, body);
        if (!is_new) {
            file_.fail(object ? *object : node, what + " stands for the object " + quote(word) +
                                                    ", but so does '" + world_[other->second].model->name +
                                                    "'");
        }
    }

    std::vector<GraspKind> grasps_of(const YAML::Node& node, const std::string& what) const {
        std::vector<GraspKind> kinds;
        file_.require_list(node, what + ": grasps");
        for (const YAML::Node& item : node) {
            const std::string kind = file_.text(item, what + ": a grasp");
            if (kind != "top" && kind != "side") file_.fail(item, what + ": grasps are 'top' and 'side'");
            kinds.push_back(kind == "top" ? GraspKind::top : GraspKind::side);
        }
        return kinds;
    }

    void add_surface(const YAML::Node& node) {
        Surface surface;
        surface.name = name_of(node, "a surface");
        const std::string what = "surface " + quote(surface.name);
        file_.require_keys(node, what, {"name", "body", "shape", "pose", "size"});
        require_new_place(node, surface.name, what);
        if (const auto body = optional(node, "body")) surface.body = require_body(*body, what);
        const auto size = optional(node, "size");
        const auto pose = optional(node, "pose");
        if (size) {
            if (optional(node, "shape")) file_.fail(node, what + " has both shape and size");
            surface.size = size_of(*size, what + ": size");
            if (pose) surface.pose = read_scene_pose(file_, *pose, what + ": pose");
        } else if (surface.body < 0 || pose) {
            file_.fail(node, what + " needs a size", "or a body only: then it is the top of that");
        } else {
            set_top(surface, node, what);
        }
        scene_.surfaces.push_back(std::move(surface));
    }

    void set_top(Surface& surface, const YAML::Node& node, const std::string& what) const {
        const std::vector<PlacedShape>& shapes = world_[surface.body].model->shapes;
        std::size_t index = 0;
        if (const auto shape = optional(node, "shape")) {
            const double number = file_.number(*shape, what + ": shape");
            if (!(number >= 0 && number < static_cast<double>(shapes.size()))) {
                file_.fail(*shape, what + ": the body has shapes 0 to " + std::to_string(shapes.size() - 1));
            }
            index = static_cast<std::size_t>(number);
        }
        double height = 0;
        if (const auto* box = std::get_if<Box>(&shapes[index].shape)) {
            surface.size = {box->size.x(), box->size.y()};
            height = 0.5 * box->size.z();
        } else if (const auto* cylinder = std::get_if<Cylinder>(&shapes[index].shape)) {
            surface.size = {std::numbers::sqrt2 * cylinder->radius, std::numbers::sqrt2 * cylinder->radius};
            height = 0.5 * cylinder->length;
        } else {
            file_.fail(node, what + ": only boxes and cylinders have a top", "give pose and size");
        }
        surface.pose = shapes[index].pose * Eigen::Translation3d(0, 0, height);
    }

    int require_body(const YAML::Node& node, const std::string& what) const {
        const std::string name = file_.text(node, what + ": body");
        const int body = world_.find(name);
        if (body < 0)
            file_.fail(node, what + ": there is no body " + quote(name), suggest(name, body_names()));
        return body;
    }

    int require_surface(const YAML::Node& node, const std::string& what) const {
        const std::string name = file_.text(node, what + ": a surface");
        const int surface = scene_.find_surface(name);
        if (surface < 0) {
            file_.fail(node, what + ": there is no surface " + quote(name),
                       suggest(name, names_of(scene_.surfaces)));
        }
        return surface;
    }

    void require_new_place(const YAML::Node& node, const std::string& name, const std::string& what) const {
        if (scene_.find_surface(name) >= 0 || scene_.find_region(name) >= 0) {
            file_.fail(node, what + ": there is a surface or region of this name already");
        }
    }

    /// Bodies that stand `on` a surface, one after the other: what one of them carries must come later.
    void place_body(const YAML::Node& node) {
        const auto on = optional(node, "on");
        if (!on) return;
        const std::string name = name_of(node, "a body");
        const std::string what = "body " + quote(name);
        const int body = world_.find(name);
        const int surface = require_surface(*on, what);
        if (scene_.surfaces[static_cast<std::size_t>(surface)].body == body) {
            file_.fail(*on, what + " cannot stand on itself");
        }
        const auto at = optional(node, "at");
        const std::array<double, 2> place = at ? pair_of(*at, what + ": at") : std::array<double, 2>{0, 0};
        world_ = world_.with_pose(
            body, placement(scene_, *world_[body].model, surface, place[0], place[1], yaw_of(node, what)));
        scene_.world = std::make_shared<const World>(world_);
    }

    void add_region(const YAML::Node& node) {
        Region region;
        region.name = name_of(node, "a region");
        const std::string what = "region " + quote(region.name);
        file_.require_keys(node, what, {"name", "surface", "center", "yaw", "size"});
        require_new_place(node, region.name, what);
        region.surface = require_surface(file_.member(node, "surface", what), what);
        const Surface& surface = scene_.surfaces[static_cast<std::size_t>(region.surface)];
        const auto center = optional(node, "center");
        const std::array<double, 2> place =
            center ? pair_of(*center, what + ": center") : std::array<double, 2>{0, 0};
        const double yaw = yaw_of(node, what);
        region.pose = pose_from_rpy({place[0], place[1], 0}, {0, 0, yaw});
        const auto size = optional(node, "size");
        region.size = size ? size_of(*size, what + ": size") : surface.size;
        const std::array<double, 2> reach = {
            0.5 * (std::abs(std::cos(yaw)) * region.size[0] + std::abs(std::sin(yaw)) * region.size[1]),
            0.5 * (std::abs(std::sin(yaw)) * region.size[0] + std::abs(std::cos(yaw)) * region.size[1])};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (std::abs(place[axis]) + reach[axis] > 0.5 * surface.size[axis] + 1e-9) {
                file_.fail(node, what + " does not lie within surface '" + surface.name + "'",
                           "the surface reaches from " + std::to_string(-0.5 * surface.size[axis]) + " to " +
                               std::to_string(0.5 * surface.size[axis]) + " along " +
                               (axis == 0 ? "x" : "y"));
            }
        }
        scene_.regions.push_back(std::move(region));
    }

    void add_pose(const YAML::Node& node) {
        const std::string name = folded(name_of(node, "a pose"));
        const std::string what = "pose " + quote(name);
        file_.require_keys(node, what, {"name", "pose"});
        const Pose pose = read_scene_pose(file_, file_.member(node, "pose", what), what);
        if (!scene_.poses.emplace(name, pose).second) {
            file_.fail(node, what + ": there is a pose of this name already");
        }
    }

    void add_allowed(const YAML::Node& node) {
        const std::string what = "an allowed collision";
        const std::vector<std::string> names = file_.texts(node, what);
        if (names.size() != 2) file_.fail(node, what + " is a pair of links or bodies");
        std::array<Participant, 2> pair = {};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto found = find_participant(robot_, world_, names[i]);
            if (!found) {
                std::vector<std::string> known = names_of(robot_.links);
                for (const std::string& body : body_names()) known.push_back(body);
                file_.fail(node[i], "there is no link or body " + quote(names[i]), suggest(names[i], known));
            }
            pair[i] = *found;
        }
        if (pair[0] == pair[1]) file_.fail(node, what + " is a pair of two different ones");
        allow_collision(robot_, world_, pair[0], pair[1]);
    }

    std::vector<std::string> body_names() const {
        std::vector<std::string> names;
        for (const BodyState& body : world_.bodies()) names.push_back(body.model->name);
        return names;
    }

    void read_stream_options(const YAML::Node& node) {
        if (!is_given(node)) return;
        file_.require_map(node, "stream_options");
        for (const auto& item : node) {
            const std::string key = file_.text(item.first, "a stream option");
            if (!scene_.stream_options.emplace(key, file_.text(item.second, "stream option " + quote(key)))
                     .second) {
                file_.fail(item.first, "the stream option " + quote(key) + " is given twice");
            }
        }
    }

    const YamlDocument& file_;
    fs::path folder_;
    Scene scene_;
    Robot robot_;
    World world_;
};

}  // namespace

Scene read_scene(const std::string& file) {
    return parse_scene(read_source(file));
}

Scene parse_scene(const Source& source) {
    const YamlDocument file(source);
    return SceneReader(file, fs::path(source.name).parent_path()).read();
}

}  // namespace praxis::tamp
