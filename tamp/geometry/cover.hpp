// Covers: sets of balls that contain a shape wholly.
//
// Whatever is free of the balls is free of the shape, so a fast collision checker may decide on balls alone.
// How far balls stick out of the shape (the *overhang*) decides how often it cannot. Spheres, boxes,
// cylinders and capsules are solid: every inner point is in some ball. Of meshes the surface is covered, and
// what lies between the ball's centre and the surface with it.
//
// Constructions. A capsule: balls on its segment. A box: the balls around the cells of a grid. A cylinder:
// layers of a disc and rings cut into sectors, or balls on its axis and rings of balls at its edges. A mesh:
// clusters of triangles, halved where the ball hangs over most. Each uses as few balls as reach the wanted
// overhang, or the best that the limit of their number allows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

struct CoverOptions {
    double overhang = 0.015;     ///< metres that a ball should stick out of the shape at most; > 0
    std::size_t max_balls = 32;  ///< for each shape; 1 to 100000, and stronger than `overhang`
};

/// Balls in the frame of the shape. Throws std::invalid_argument for a shape with sizes that are negative or
/// not finite, for a mesh without triangles or with indices out of range, for options out of range, and for
/// occupancy maps, which have no cover.
std::vector<Ball> cover(const Shape& shape, const CoverOptions& options = {});

/// Covers of several shapes in the frame that they are placed in, without balls inside of other balls.
std::vector<Ball> cover(std::span<const PlacedShape> shapes, const CoverOptions& options = {});

/// A ball around all of these, at most a few percent larger than the smallest one (Badoiu and Clarkson,
/// "Smaller core-sets for balls", SODA 2003). Radius 0 at the origin if there are none.
Ball bounding_ball(std::span<const Ball> balls);

/// The smallest ball around both.
Ball bounding_ball(const Ball& first, const Ball& second);

}  // namespace praxis::tamp
