#include "tamp/scenes/scene_shapes.hpp"

#include <optional>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/geometry/mesh_file.hpp"
#include "tamp/scenes/map_points.hpp"
#include "tamp/scenes/read_octomap.hpp"
#include "tamp/scenes/read_points.hpp"

namespace praxis::tamp {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostShapes = 10'000;
constexpr std::uintmax_t kLargestMap = std::uintmax_t{1} << 30;
constexpr const char* kKinds[] = {"box", "sphere", "cylinder", "capsule", "mesh", "octomap", "points"};

class ShapeReader {
  public:
    ShapeReader(const YamlDocument& file, std::string what, const fs::path& folder)
        : file_(file), what_(std::move(what)), folder_(folder) {}

    Shape read(const std::string& kind, const YAML::Node& node) const {
        if (kind == "box") {
            file_.numbers(node, what_ + ": a box", 3);
            return Box{{file_.length(node[0], size_of("box")), file_.length(node[1], size_of("box")),
                        file_.length(node[2], size_of("box"))}};
        }
        if (kind == "sphere") return Sphere{round(node, "sphere", {"radius"})[0]};
        if (kind == "cylinder" || kind == "capsule") {
            const std::vector<double> sizes = round(node, kind, {"radius", "length"});
            if (kind == "cylinder") return Cylinder{sizes[0], sizes[1]};
            return Capsule{sizes[0], sizes[1]};
        }
        if (kind == "mesh") return mesh(node);
        return kind == "octomap" ? octomap(node) : points(node);
    }

  private:
    std::string size_of(const std::string& kind) const { return what_ + ": a size of a " + kind; }

    std::vector<double> round(const YAML::Node& node, const std::string& kind,
                              std::initializer_list<std::string_view> keys) const {
        file_.require_keys(node, what_ + ": " + kind, keys);
        std::vector<double> sizes;
        for (const std::string_view key : keys) {
            const YAML::Node size = file_.member(node, key.data(), what_ + ": " + kind);
            sizes.push_back(file_.length(size, size_of(kind)));
        }
        return sizes;
    }

    /// A file's name, given as it is or as `file` of a map with these keys.
    YAML::Node file_node(const YAML::Node& node, const std::string& kind,
                         std::initializer_list<std::string_view> keys) const {
        if (node.IsScalar()) return node;
        file_.require_keys(node, what_ + ": " + kind, keys);
        return file_.member(node, "file", what_ + ": " + kind);
    }

    /// Runs a reader of another file; what it complains of is told together with the place in the scene.
    template <class Read>
    auto from_file(const YAML::Node& node, Read&& read) const {
        const fs::path path = folder_ / file_.text(node, what_ + ": the file");
        std::error_code error;
        if (!fs::is_regular_file(path, error))
            file_.fail(node, what_ + ": there is no file " + path.string());
        if (fs::file_size(path, error) > kLargestMap) {
            file_.fail(node, what_ + ": the file is larger than 1 GiB");
        }
        try {
            return read(path.string());
        } catch (const InputError& problem) {
            file_.fail(node, what_ + ": this file cannot be used", problem.what());
        } catch (const std::invalid_argument& problem) {
            file_.fail(node, what_ + ": " + problem.what());
        }
    }

    Shape mesh(const YAML::Node& node) const {
        const YAML::Node name = file_node(node, "mesh", {"file", "scale"});
        Vector3 scale = Vector3::Ones();
        const YAML::Node given = YamlDocument::find(node, "scale");
        if (is_given(given)) {
            scale = given.IsScalar() ? Vector3::Constant(file_.length(given, what_ + ": the scale")).eval()
                                     : file_.vector(given, what_ + ": the scale");
        }
        return from_file(name, [&](const std::string& path) { return read_mesh(path, scale); });
    }

    std::optional<AxisBox> map_box(const YAML::Node& node) const {
        const YAML::Node given = YamlDocument::find(node, "bounds");
        if (!is_given(given)) return std::nullopt;
        const std::string what = what_ + ": bounds";
        file_.require_list(given, what);
        if (given.size() != 2) file_.fail(given, what + " must be two corners: [[x, y, z], [x, y, z]]");
        const AxisBox box = {file_.vector(given[0], what), file_.vector(given[1], what)};
        if (!(box.lower.array() < box.upper.array()).all()) {
            file_.fail(given, what + " must have the lower corner first");
        }
        return box;
    }

    bool unknown_blocks(const YAML::Node& node) const {
        const YAML::Node given = YamlDocument::find(node, "unknown");
        if (!is_given(given)) return true;
        const std::string word = file_.text(given, what_ + ": unknown");
        if (word != "obstacle" && word != "free") {
            file_.fail(given, what_ + ": unknown voxels are 'obstacle' or 'free'");
        }
        return word == "obstacle";
    }

    Shape octomap(const YAML::Node& node) const {
        const YAML::Node name = file_node(node, "octomap", {"file", "bounds", "unknown"});
        const OctomapOptions options = {map_box(node), unknown_blocks(node)};
        return from_file(name, [&](const std::string& path) {
            return std::make_shared<const OccupancyMap>(parse_octomap(read_source(path), options));
        });
    }

    Shape points(const YAML::Node& node) const {
        const YAML::Node name =
            file_node(node, "points", {"file", "edge", "bounds", "sensor", "least_points", "unknown"});
        PointMapOptions options;
        options.box = map_box(node);
        options.unknown_blocks = unknown_blocks(node);
        const YAML::Node edge = YamlDocument::find(node, "edge");
        if (is_given(edge)) options.edge = file_.length(edge, what_ + ": the edge of a voxel");
        const YAML::Node sensor = YamlDocument::find(node, "sensor");
        if (is_given(sensor)) options.sensor = file_.vector(sensor, what_ + ": the sensor");
        const YAML::Node least = YamlDocument::find(node, "least_points");
        if (is_given(least)) {
            const double count = file_.number(least, what_ + ": least_points");
            if (!(count >= 1 && count <= 1e6 && count == static_cast<double>(static_cast<int>(count)))) {
                file_.fail(least, what_ + ": least_points must be a whole number of 1 or more");
            }
            options.least_points = static_cast<std::size_t>(count);
        }
        return from_file(name, [&](const std::string& path) {
            return std::make_shared<const OccupancyMap>(map_points(parse_points(read_source(path)), options));
        });
    }

    const YamlDocument& file_;
    std::string what_;
    const fs::path& folder_;
};

/// The one kind of shape that a map has among its keys; nothing if it has none.
std::optional<std::string> kind_in(const YamlDocument& file, const YAML::Node& node,
                                   const std::string& what) {
    std::optional<std::string> found;
    for (const char* kind : kKinds) {
        if (!YamlDocument::find(node, kind).IsDefined()) continue;
        if (found)
            file.fail(node, what + " has two shapes, " + *found + " and " + kind, "use a list 'shapes'");
        found = kind;
    }
    return found;
}

}  // namespace

Pose read_scene_pose(const YamlDocument& file, const YAML::Node& node, const std::string& what) {
    file.require_keys(node, what, {"xyz", "rpy", "quaternion"});
    const YAML::Node xyz = YamlDocument::find(node, "xyz");
    const YAML::Node rpy = YamlDocument::find(node, "rpy");
    const YAML::Node quaternion = YamlDocument::find(node, "quaternion");
    const Vector3 place = is_given(xyz) ? file.vector(xyz, what + ": xyz") : Vector3::Zero();
    if (is_given(rpy) && is_given(quaternion)) file.fail(node, what + " has both rpy and quaternion");
    if (!is_given(quaternion)) {
        return pose_from_rpy(place, is_given(rpy) ? file.vector(rpy, what + ": rpy") : Vector3::Zero());
    }
    const std::vector<double> q = file.numbers(quaternion, what + ": quaternion", 4);
    try {
        return pose_from_quaternion(place, {q[0], q[1], q[2], q[3]});
    } catch (const std::invalid_argument& error) {
        file.fail(quaternion, what + ": " + error.what());
    }
}

std::vector<PlacedShape> read_scene_shapes(const YamlDocument& file, const YAML::Node& body,
                                           const std::string& what, const fs::path& folder) {
    const ShapeReader reader(file, what, folder);
    const std::optional<std::string> own = kind_in(file, body, what);
    const YAML::Node list = YamlDocument::find(body, "shapes");
    if (own && list.IsDefined()) file.fail(list, what + " has both " + *own + " and shapes");
    if (own) return {{Pose::Identity(), reader.read(*own, body[*own])}};
    if (!list.IsDefined())
        file.fail(body, what + " has no shape", "give a box, sphere, cylinder, ... or 'shapes'");
    file.require_list(list, what + ": shapes");
    if (list.size() == 0 || list.size() > kMostShapes) file.fail(list, what + " must have 1 to 10000 shapes");
    std::vector<PlacedShape> shapes;
    for (const YAML::Node& node : list) {
        file.require_keys(node, what + ": a shape",
                          {"pose", "box", "sphere", "cylinder", "capsule", "mesh", "octomap", "points"});
        const std::optional<std::string> kind = kind_in(file, node, what + ": a shape");
        if (!kind) file.fail(node, what + " has a shape of no kind", "give a box, sphere, cylinder, ...");
        const YAML::Node pose = YamlDocument::find(node, "pose");
        shapes.push_back(
            {is_given(pose) ? read_scene_pose(file, pose, what + ": the pose of a shape") : Pose::Identity(),
             reader.read(*kind, node[*kind])});
    }
    return shapes;
}

}  // namespace praxis::tamp
