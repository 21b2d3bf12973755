// Triangle meshes out of files.
#pragma once

#include <memory>
#include <string>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// Reads a mesh (STL, OBJ, PLY, OFF, COLLADA, glTF) and multiplies its coordinates by `scale`. All parts of a
/// file become one triangle soup; points and lines in it are left out; the axes are taken as they stand.
/// Limits: 256 MiB, two million triangles. Throws InputError naming the file.
std::shared_ptr<const Mesh> read_mesh(const std::string& file, const Vector3& scale = Vector3::Ones());

}  // namespace praxis::tamp
