// The balls that stand for a link or a body, in clusters with balls around them: what the fast checker reads.
// They depend on the link or body alone, so `SolidCache` keeps them from one checker to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// Which balls stand for the shapes.
enum class BallSide : std::uint8_t {
    outer,  ///< they contain the shapes: free of them means free
    inner   ///< the shapes contain them: a contact of them is a contact
};

struct BallClusters {
    struct Cluster {
        Ball bound = {};
        std::size_t ball_count = 0;
    };
    std::vector<Ball> balls = {};  ///< cluster by cluster
    std::vector<Cluster> clusters = {};
    Ball bound = {};
    bool exact = true;  ///< the shapes are these balls
};

/// Clusters of the shapes themselves where all are spheres, else of `cover`, which covers the shapes; of its
/// balls the inner ones keep what is inside of a shape.
BallClusters cluster_balls(const std::vector<PlacedShape>& shapes, const std::vector<Ball>& cover,
                           BallSide side);

/// What belongs to one link or body.
struct CoveringClusters {
    BallClusters outer = {};
    BallClusters inner = {};

    const BallClusters& operator[](BallSide side) const { return side == BallSide::outer ? outer : inner; }
};

}  // namespace praxis::tamp
