// Meshes as voxels.
#pragma once

#include "tamp/geometry/shape.hpp"
#include "tamp/scenes/voxel_grid.hpp"

namespace praxis::tamp {

/// All cells that a triangle of the mesh meets (by separating axes: Akenine-Moller 2001), and a few that it
/// passes by less than a millionth of an edge: no point of the surface lies outside of them. In the mesh's
/// frame. Throws std::invalid_argument for a mesh without triangles, with vertices that are not there or not
/// finite, an edge that is not above 0, or more than 67 million cells.
VoxelSet voxelize(const Mesh& mesh, double edge);

}  // namespace praxis::tamp
