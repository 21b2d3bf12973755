// The symmetries of a square lattice that planners may share weights under: none, the four rotations (C4), or
// these and the reflections (D4).
//
// An element is a 2x2 matrix of integers that acts on (row, column) offsets; element r + 4 m is the r-fold
// quarter turn (counter-clockwise as maps are drawn) after m mirrorings of the columns. A representation says
// how an element permutes the channels of a field; the field g f has the value f[g^-1 k](g^-1 x) in channel k
// at x.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace praxis::learned {

/// An offset between cells.
struct Offset {
    int row = 0, column = 0;
    bool operator==(const Offset&) const = default;
};

/// The four moves, in the order of the policy's channels: north, west, south, east.
inline constexpr std::array<Offset, 4> kMoves{{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}};

class Group {
  public:
    /// "c1", "c4" or "d4"; std::invalid_argument for anything else.
    explicit Group(std::string_view name);

    const std::string& name() const { return name_; }
    int order() const { return static_cast<int>(elements_.size()); }
    /// The element that does `second` first: (first second) x = first (second x).
    int product(int first, int second) const;
    int inverse(int element) const;
    Offset apply(int element, Offset offset) const;

  private:
    using Matrix = std::array<int, 4>;
    int find(const Matrix& matrix) const;

    std::string name_;
    std::vector<Matrix> elements_;
};

/// How the elements of a group permute `size` channels: the channel k becomes action[element * size + k].
struct Representation {
    int size = 1;
    std::vector<int> action;
    int operator()(int element, int channel) const {
        return action[static_cast<std::size_t>(element * size + channel)];
    }
};

/// One channel that no element changes.
Representation trivial(const Group& group);
/// One channel an element h; g makes it g h.
Representation regular(const Group& group);
/// One channel a move of kMoves, turned with the map.
Representation moves(const Group& group);

}  // namespace praxis::learned
