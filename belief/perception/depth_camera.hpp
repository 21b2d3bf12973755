// From a pixel to a place in the world: a pinhole camera with a depth image.
//
// The camera looks along its z axis; x points to the right of the image and y down (the convention of OpenCV
// and ROS optical frames). Depth is the distance along z, in metres. Pixel (u, v) is column u, row v; the
// centre of the first pixel is (0, 0).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "belief/percept.hpp"

namespace praxis::belief {

struct Pinhole {
    double fx = 1, fy = 1;  ///< focal lengths in pixels; positive
    double cx = 0, cy = 0;  ///< the pixel that the axis passes through
};

/// world = rotation * camera + translation.
struct CameraPose {
    std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Position translation;
};

struct DepthImage {
    std::size_t width = 0, height = 0;
    std::vector<float> metres;  ///< row by row; zero, negative, infinite or not a number: nothing measured
};

struct DepthCamera {
    Pinhole pinhole;
    CameraPose pose;
    DepthImage depth;
    float nearest = 0.02F;  ///< depths outside are taken for errors
    float farthest = 20.0F;

    /// Throws PerceptionError if the depth image has not width * height values or a focal length is not
    /// positive.
    void check() const;

    /// The point of the world seen at a pixel: the median of the valid depths among the 3 x 3 pixels around
    /// it, since single ones fail at edges. Nothing outside of the image, or if fewer than half of those
    /// pixels are valid.
    std::optional<Position> lift(double u, double v) const;

    /// Where a point of the world appears; nothing if it is behind the camera.
    std::optional<std::array<double, 2>> project(const Position& point) const;
};

}  // namespace praxis::belief
