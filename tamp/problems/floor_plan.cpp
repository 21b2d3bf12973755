#include "tamp/problems/floor_plan.hpp"

#include <numeric>

#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

/// Which rooms are connected: union-find.
class Components {
  public:
    explicit Components(int count) : parent_(static_cast<std::size_t>(count)) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    /// False if they were connected.
    bool join(int a, int b) {
        const std::size_t first = root(static_cast<std::size_t>(a));
        const std::size_t second = root(static_cast<std::size_t>(b));
        parent_[first] = second;
        return first != second;
    }

  private:
    std::size_t root(std::size_t room) const {
        while (parent_[room] != room) room = parent_[room];
        return room;
    }

    std::vector<std::size_t> parent_;
};

class Architect {
  public:
    explicit Architect(const FloorPlanOptions& options) { plan_.options = options; }

    FloorPlan build(Random& random) {
        std::vector<Door> doors = possible_doors();
        random.shuffle(doors);
        Components connected(plan_.options.side * plan_.options.side);
        for (const Door& door : doors) {
            const bool needed = connected.join(door.from, door.to);
            if (needed || uniform(random, 0, 1) >= plan_.options.closed) {
                plan_.doors.push_back(door);
            } else {
                wall_up(door);
            }
        }
        for (const Door& door : doors) frame(door);
        surround();
        return std::move(plan_);
    }

  private:
    std::vector<Door> possible_doors() const {
        std::vector<Door> doors;
        const int side = plan_.options.side;
        const double half = plan_.pitch() / 2;
        for (int room = 0; room < side * side; ++room) {
            const Place center = plan_.center(room);
            if (room % side + 1 < side)
                doors.push_back({room, room + 1, {center[0] + half, center[1]}, false});
            if (room / side + 1 < side)
                doors.push_back({room, room + side, {center[0], center[1] + half}, true});
        }
        return doors;
    }

    /// A piece of wall of some length around a place.
    void add(const Place& center, double length, bool along_x) {
        const FloorPlanOptions& options = plan_.options;
        const Size3 size = along_x ? Size3{length, options.wall, options.height}
                                   : Size3{options.wall, length, options.height};
        plan_.walls.push_back({"wall" + std::to_string(plan_.walls.size() + 1),
                               size,
                               {center[0], center[1], options.height / 2}});
    }

    void wall_up(const Door& door) { add(door.center, plan_.options.door, door.along_x); }

    /// The wall on both sides of a door.
    void frame(const Door& door) {
        const double length = (plan_.pitch() - plan_.options.door) / 2;
        const double shift = (plan_.options.door + length) / 2;
        for (const double side : {-shift, shift}) {
            add({door.center[0] + (door.along_x ? side : 0), door.center[1] + (door.along_x ? 0 : side)},
                length, door.along_x);
        }
    }

    void surround() {
        const double whole = plan_.pitch() * plan_.options.side;
        for (const double edge : {0.0, whole}) {
            add({edge, whole / 2}, whole + plan_.options.wall, false);
            add({whole / 2, edge}, whole + plan_.options.wall, true);
        }
    }

    FloorPlan plan_;
};

}  // namespace

Place FloorPlan::center(int room) const {
    return {pitch() * (room % options.side + 0.5), pitch() * (room / options.side + 0.5)};
}

FloorPlan make_floor_plan(Random& random, const FloorPlanOptions& options) {
    return Architect(options).build(random);
}

std::string start_text(const Place& at) {
    return "{base: [" + shortest(at[0]) + ", " + shortest(at[1]) + ", 0], arm: ready, gripper: open}";
}

}  // namespace praxis::tamp
