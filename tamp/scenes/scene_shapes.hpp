// The shapes and poses of scene files. Included by their reader only.
#pragma once

#include <filesystem>

#include "tamp/geometry/shape.hpp"
#include "tamp/text/yaml_document.hpp"

namespace praxis::tamp {

/// `xyz` and `rpy` or `quaternion` (x, y, z, w), each of which may be missing.
Pose read_scene_pose(const YamlDocument& file, const YAML::Node& node, const std::string& what);

/// The shapes of a body: of its list `shapes`, or the one that the body names itself (`box: [...]`).
std::vector<PlacedShape> read_scene_shapes(const YamlDocument& file, const YAML::Node& body,
                                           const std::string& what, const std::filesystem::path& folder);

}  // namespace praxis::tamp
