#include "tamp/scenes/read_octomap.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

constexpr int kDepth = 16;  ///< levels of an OctoMap below its root
constexpr int kCenter = 1 << (kDepth - 1);

/// A cube of voxels of one kind: its lowest voxel (0 at the origin) and its side in voxels.
struct Leaf {
    std::array<int, 3> lower = {};
    int side = 1;
    bool occupied = false;
};

class Reader {
  public:
    explicit Reader(const Source& file) : file_(file), rest_(file.text) {}

    double edge() const { return edge_; }

    std::vector<Leaf> read() {
        const std::string_view first = line();
        const bool binary = first.starts_with("# Octomap OcTree binary file");
        if (!binary && !first.starts_with("# Octomap OcTree file")) {
            fail("is no OctoMap file (.bt or .ot)", "its first line says what it is: '# Octomap OcTree ...'");
        }
        read_header();
        if (binary) {
            read_binary({-kCenter, -kCenter, -kCenter}, kDepth);
        } else {
            read_odds({-kCenter, -kCenter, -kCenter}, kDepth);
        }
        return std::move(leaves_);
    }

  private:
    [[noreturn]] void fail(const std::string& what, const std::string& mend) const {
        fail_unplaced(file_.name + ": " + what + "; " + mend);
    }

    std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return result;
    }

    void read_header() {
        bool known = false;
        while (!rest_.empty()) {
            std::string_view text = line();
            if (text.ends_with('\r')) text.remove_suffix(1);
            if (text == "data") {
                if (!known) fail("does not say which kind of tree it holds", "its header needs 'id OcTree'");
                if (!(edge_ > 0) || !std::isfinite(edge_)) {
                    fail("has no resolution above 0", "its header needs a line such as 'res 0.05'");
                }
                return;
            }
            if (text.starts_with("id ")) {
                if (text.substr(3) != "OcTree") {
                    fail("holds a tree of kind " + quote(text.substr(3)), "convert it to OcTree");
                }
                known = true;
            } else if (text.starts_with("res ")) {
                std::from_chars(text.data() + 4, text.data() + text.size(), edge_);
            }
        }
        fail("ends within its header", "write it again");
    }

    template <class T>
    T take() {
        if (rest_.size() < sizeof(T)) fail("ends too early", "write it again");
        T value;
        std::memcpy(&value, rest_.data(), sizeof(T));
        rest_.remove_prefix(sizeof(T));
        return value;
    }

    static std::array<int, 3> child(const std::array<int, 3>& lower, int which, int side) {
        return {lower[0] + ((which & 1) != 0 ? side : 0), lower[1] + ((which & 2) != 0 ? side : 0),
                lower[2] + ((which & 4) != 0 ? side : 0)};
    }

    void require_depth(int levels) const {
        if (levels <= 0) fail("is damaged: its tree is deeper than 16 levels", "write it again");
    }

    /// Two bits a child: nothing known, free, occupied, or children of its own, which follow.
    void read_binary(const std::array<int, 3>& lower, int levels) {
        require_depth(levels);
        const auto bits = take<std::uint16_t>();
        const int side = 1 << (levels - 1);
        for (int i = 0; i < 8; ++i) {
            const int kind = (bits >> (2 * i)) & 3;
            if (kind == 1 || kind == 2) leaves_.push_back({child(lower, i, side), side, kind == 2});
        }
        for (int i = 0; i < 8; ++i) {
            if (((bits >> (2 * i)) & 3) == 3) read_binary(child(lower, i, side), levels - 1);
        }
    }

    /// The log-odds, then a bit a child, then those children.
    void read_odds(const std::array<int, 3>& lower, int levels) {
        const auto odds = take<float>();
        const auto children = take<std::uint8_t>();
        if (std::isnan(odds)) fail("is damaged: it has a value that is no number", "write it again");
        if (children == 0) leaves_.push_back({lower, 1 << levels, odds >= 0});
        for (int i = 0; i < 8; ++i) {
            if (((children >> i) & 1) == 0) continue;
            require_depth(levels);
            const int side = 1 << (levels - 1);
            read_odds(child(lower, i, side), levels - 1);
        }
    }

    const Source& file_;
    std::string_view rest_;
    double edge_ = 0;
    std::vector<Leaf> leaves_;
};

AxisBox box_around_all(const std::vector<Leaf>& leaves, double edge) {
    const auto box_of = [&](const Leaf& leaf) {
        const Vector3 lower = edge * Vector3(leaf.lower[0], leaf.lower[1], leaf.lower[2]);
        return AxisBox{lower, lower.array() + edge * leaf.side};
    };
    AxisBox box = box_of(leaves.front());
    for (const Leaf& leaf : leaves) box.include(box_of(leaf));
    return box;
}

}  // namespace

OccupancyMap parse_octomap(const Source& file, const OctomapOptions& options) {
    Reader reader(file);
    const std::vector<Leaf> leaves = reader.read();
    if (leaves.empty() && !options.box) fail_unplaced(file.name + ": has no voxel that is known; give a box");
    try {
        const VoxelGrid grid =
            aligned_grid(options.box ? *options.box : box_around_all(leaves, reader.edge()), reader.edge());
        std::vector<Occupancy> cells(grid.size(), Occupancy::unknown);
        std::array<int, 3> first = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first[axis] = static_cast<int>(std::lround(grid.origin[axis] / grid.edge));
        }
        for (const Leaf& leaf : leaves) {
            CellBox box;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box.lower[axis] = std::clamp(leaf.lower[axis] - first[axis], 0, grid.cells[axis]);
                box.upper[axis] = std::clamp(leaf.lower[axis] + leaf.side - first[axis], 0, grid.cells[axis]);
            }
            if (box.lower[0] == box.upper[0]) continue;
            for (int k = box.lower[2]; k < box.upper[2]; ++k) {
                for (int j = box.lower[1]; j < box.upper[1]; ++j) {
                    std::fill_n(&cells[grid.index(box.lower[0], j, k)], box.upper[0] - box.lower[0],
                                leaf.occupied ? Occupancy::occupied : Occupancy::free);
                }
            }
        }
        return OccupancyMap(grid, std::move(cells), options.unknown_blocks);
    } catch (const std::invalid_argument& error) {
        fail_unplaced(file.name + ": " + error.what());
    }
}

}  // namespace praxis::tamp
