// Meshes in voxels.
#pragma once

#include "tamp/geometry/shape.hpp"
#include "tamp/scenes/voxel_grid.hpp"

namespace praxis::tamp {

/// Every voxel that the surface touches, and of their neighbours no more than those that share a corner with
/// such a one; with about `resolution` voxels along the longest side. In the frame of the mesh. Throws
/// std::invalid_argument for a mesh without triangles, with vertices that are not finite, or with indices out
/// of range, and for resolutions out of 1 to 256.
VoxelSet voxels_of(const Mesh& mesh, int resolution = 64);

}  // namespace praxis::tamp
