// Shapes as FCL sees them.
//
// A `Solid` is one shape with its place in the frame of its owner (a link or a body); its geometry is shared
// and immutable. Meshes and maps take long to prepare: a `SolidCache` keeps them from one checker to the
// next.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "tamp/collision/ball_clusters.hpp"
#include "tamp/geometry/box_tree.hpp"
#include "tamp/geometry/shape.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/scenes/distance_grid.hpp"
#include "tamp/scenes/world.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace praxis::tamp {

/// The obstacles of an occupancy map, in its frame.
struct MapBoxes {
    std::vector<AxisBox> boxes = {};
    BoxTree tree = {};
};

/// A mesh: for FCL, and for balls, whose distances to triangles are compared.
struct MeshTriangles {
    std::vector<Vector3> vertices = {};
    std::vector<std::array<std::uint32_t, 3>> triangles = {};
    BoxTree tree = {};
    std::shared_ptr<const fcl::CollisionGeometry<double>> geometry = {};
};

struct Solid {
    Pose pose = Pose::Identity();                                         ///< in the frame of the owner
    std::shared_ptr<const fcl::CollisionGeometry<double>> geometry = {};  ///< none: a map
    std::shared_ptr<const MapBoxes> map = {};
    std::shared_ptr<const MeshTriangles> mesh = {};
    double radius = -1;   ///< of a sphere; -1: not one
    AxisBox extent = {};  ///< of the geometry, in its own frame
    Ball bound = {};      ///< around it, in the frame of the owner
};

/// Whether two solids have a point in common, given their poses in the world.
bool touch(const Solid& first, const Pose& first_pose, const Solid& second, const Pose& second_pose);

/// Around all; radius 0 if there are none.
Ball bound_of(const std::vector<Solid>& solids);

/// Makes solids, and keeps what meshes, maps, robots and bodies were turned into as long as these live.
/// Several threads may share one.
class SolidCache {
  public:
    /// Throws std::invalid_argument if a number of a shape is not finite or not positive.
    std::vector<Solid> make(const std::vector<PlacedShape>& shapes);
    /// Distances to the surface of a mesh, and to the obstacles of a map.
    std::shared_ptr<const DistanceGrid> distances(const std::shared_ptr<const Mesh>& mesh);
    std::shared_ptr<const DistanceGrid> distances(const std::shared_ptr<const OccupancyMap>& map);

    /// By link, and of a body.
    std::shared_ptr<const std::vector<CoveringClusters>> clusters(const std::shared_ptr<const Robot>& robot);
    std::shared_ptr<const CoveringClusters> clusters(const std::shared_ptr<const BodyModel>& body);

  private:
    /// What was made of something that others own.
    template <class From, class Made>
    class Kept {
      public:
        template <class Make>
        std::shared_ptr<const Made> get(const std::shared_ptr<const From>& from, Make&& make);

      private:
        struct Entry {
            std::weak_ptr<const From> from;
            std::shared_ptr<const Made> made;
        };
        std::mutex mutex_;
        std::unordered_map<const From*, Entry> entries_;
    };
    Kept<Mesh, MeshTriangles> meshes_;
    Kept<OccupancyMap, MapBoxes> maps_;
    Kept<Mesh, DistanceGrid> mesh_distances_;
    Kept<OccupancyMap, DistanceGrid> map_distances_;
    Kept<Robot, std::vector<CoveringClusters>> links_;
    Kept<BodyModel, CoveringClusters> bodies_;
};

}  // namespace praxis::tamp
