// Square rooms in a square, with doors in the middle of the walls between them.
#pragma once

#include <string>
#include <vector>

#include "tamp/problems/families.hpp"
#include "tamp/problems/problem_text.hpp"

namespace praxis::tamp {

struct Wall {
    std::string name = {};
    Size3 size = {};
    Size3 center = {};
};

struct FloorPlanOptions {
    int side = 2;         ///< rooms along a side
    double room = 3;      ///< metres along a side of a room, from wall to wall
    double door = 1;      ///< metres that a door is wide
    double wall = 0.1;    ///< metres that walls are thick
    double height = 1;    ///< metres
    double closed = 0.3;  ///< share of the doors that are walled up; the rooms stay connected
};

struct Door {
    int from = 0, to = 0;  ///< rooms
    Place center = {};
    bool along_x = false;  ///< the wall with the door runs along x
};

struct FloorPlan {
    FloorPlanOptions options = {};
    std::vector<Wall> walls = {};
    std::vector<Door> doors = {};

    /// Room 0 is in the corner with the smallest x and y; its neighbour along x is room 1. The corner of the
    /// whole is at the origin.
    Place center(int room) const;
    double pitch() const { return options.room + options.wall; }
};

FloorPlan make_floor_plan(Random& random, const FloorPlanOptions& options);

/// YAML of the start of a mobile robot that stands there, with the arm ready.
std::string start_text(const Place& at);

}  // namespace praxis::tamp
