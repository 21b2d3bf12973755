// Poses of a mobile base on a lattice, and the ways between them that the fewest bodies stand in.
//
// A base that drives to many places from one start asks the same questions again and again. So what is in the
// way is found out once: which poses touch fixed bodies (when it is first asked for), and which poses each
// movable body takes where it stands. A search over the lattice then needs no checks of collisions, goes on
// from one goal to the next, and, where there is no way, names the bodies that would have to go: a way that
// takes the fewest of them (minimum constraint removal, Hauser 2012; bodies are counted again where a way
// comes back to them).
//
// The lattice tells what is worth a try. Edges between its poses are not checked.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <queue>
#include <span>
#include <vector>

#include "tamp/collision/checker.hpp"
#include "tamp/geometry/axis_box.hpp"

namespace praxis::tamp {

struct BaseLatticeOptions {
    double cell = 0.1;                   ///< metres from one pose to the next, at least
    std::size_t most_poses = 1U << 22U;  ///< cells are larger where there were more
};

/// Base poses (x, y, yaw): the start's neighbours, and theirs; eight steps of yaw make a turn, and half a
/// turn to either side is covered, so that paths do not wind.
class BaseLattice {
  public:
    using Pose = std::uint32_t;  ///< number of a pose
    static constexpr int kYaws = 9;
    static constexpr int kNeighbours = 10;

    /// Around `start` as far as the box reaches along x and y.
    BaseLattice(const Configuration& start, const AxisBox& extent, const BaseLatticeOptions& options = {});

    std::size_t size() const {
        return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * kYaws;
    }
    double cell() const { return cell_; }
    Pose start() const { return at(start_column_, start_row_, kYaws / 2); }
    Configuration positions(Pose pose) const;
    /// Poses around these positions, the nearest first; empty outside of the lattice.
    std::vector<Pose> around(const Configuration& positions) const;
    /// Poses whose x and y are within `radius` of a point.
    std::vector<Pose> within(double x, double y, double radius) const;
    /// Calls `visit(neighbour, length)`, with lengths in hundredths of a cell.
    template <class Visit>
    void visit_neighbours(Pose pose, Visit&& visit) const;

  private:
    Pose at(int column, int row, int yaw) const {
        return static_cast<Pose>((row * columns_ + column) * kYaws + yaw);
    }

    Configuration origin_;  ///< the start
    double cell_;
    int columns_, rows_, start_column_, start_row_;
};

/// Which poses of a lattice are within limits and free of the fixed bodies, for one shape of the robot.
class LatticeMap {
  public:
    /// `fixed`: of the base's group, among the fixed bodies alone.
    LatticeMap(const BaseLattice& lattice, std::unique_ptr<CollisionChecker> fixed);

    const BaseLattice& lattice() const { return lattice_; }
    CollisionChecker& fixed() { return *fixed_; }
    bool is_free(BaseLattice::Pose pose);
    /// The poses that touch what `one` checks, which is within `radius` of (x, y) for the whole robot.
    std::vector<BaseLattice::Pose> touching(CollisionChecker& one, double x, double y, double radius) const;

  private:
    enum class Known : std::uint8_t { no, free, taken };

    const BaseLattice& lattice_;
    std::unique_ptr<CollisionChecker> fixed_;
    std::vector<Known> known_;
};

/// Ways from the start to goals, one after the other, while certain bodies stand where they stand.
class LatticeSearch {
  public:
    using Pose = BaseLattice::Pose;

    /// `taken`: by body, the poses that it takes. Keeps references to all.
    LatticeSearch(LatticeMap& map, std::vector<const std::vector<Pose>*> taken);

    struct Way {
        bool found = false;            ///< false: not even with all bodies gone
        std::vector<Pose> poses = {};  ///< from the start to one beside the goal
        std::vector<int> bodies =
            {};  ///< whose poses it needs, by their number in `taken`, in increasing order
    };

    /// To these positions, whose lattice poses around them are the last before the goal. What is beside the
    /// goal is joined to it by a straight motion that no fixed body stops.
    const Way& to(const Configuration& goal);

  private:
    struct Entry {
        std::uint32_t removals, length;
        Pose pose;
        auto key() const { return std::pair(removals, length); }
        bool operator>(const Entry& other) const { return key() > other.key(); }
    };
    struct Node {
        std::uint32_t removals = ~0U, length = ~0U;
        Pose parent = 0;
        bool settled = false;
    };
    struct Link {
        int body = 0;
        std::uint32_t next = 0;
    };

    void reach(Pose pose, Pose parent, std::uint32_t removals, std::uint32_t length);
    void settle_next();
    /// Bodies that take a pose and do not take the one before.
    std::uint32_t removals(Pose before, Pose pose) const;
    Way way_to(Pose last) const;

    LatticeMap& map_;
    std::vector<const std::vector<Pose>*> taken_;
    std::vector<std::uint32_t> heads_;  ///< by pose: 1 + the first of `links_`; 0: no body
    std::vector<Link> links_;
    std::vector<Node> nodes_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
    std::deque<std::pair<Configuration, Way>> answers_;
};

template <class Visit>
void BaseLattice::visit_neighbours(Pose pose, Visit&& visit) const {
    constexpr std::uint32_t kStraight = 100, kDiagonal = 141, kTurn = 100;
    const int number = static_cast<int>(pose);
    const int yaw = number % kYaws;
    const int column = number / kYaws % columns_;
    const int row = number / kYaws / columns_;
    for (int down = -1; down <= 1; ++down) {
        for (int right = -1; right <= 1; ++right) {
            if (right == 0 && down == 0) continue;
            const int x = column + right, y = row + down;
            if (x < 0 || y < 0 || x >= columns_ || y >= rows_) continue;
            visit(at(x, y, yaw), right != 0 && down != 0 ? kDiagonal : kStraight);
        }
    }
    if (yaw > 0) visit(at(column, row, yaw - 1), kTurn);
    if (yaw + 1 < kYaws) visit(at(column, row, yaw + 1), kTurn);
}

}  // namespace praxis::tamp
