#include "learned/groups/group.hpp"

#include <algorithm>
#include <stdexcept>

namespace praxis::learned {
namespace {

std::array<int, 4> multiply(const std::array<int, 4>& a, const std::array<int, 4>& b) {
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3]};
}

template <class Image>
Representation representation(const Group& group, int size, const Image& image) {
    Representation result{size, {}};
    for (int g = 0; g < group.order(); ++g)
        for (int k = 0; k < size; ++k) result.action.push_back(image(g, k));
    return result;
}

}  // namespace

Group::Group(std::string_view name) : name_(name) {
    constexpr Matrix kTurn{0, -1, 1, 0}, kMirror{1, 0, 0, -1}, kIdentity{1, 0, 0, 1};
    if (name != "c1" && name != "c4" && name != "d4")
        throw std::invalid_argument("unknown symmetry group '" + name_ + "' (known: c1, c4, d4)");
    const int turns = name == "c1" ? 1 : 4;
    for (Matrix start : {kIdentity, kMirror}) {
        for (int r = 0; r < turns; ++r, start = multiply(kTurn, start)) elements_.push_back(start);
        if (name != "d4") break;
    }
}

int Group::find(const Matrix& matrix) const {
    return static_cast<int>(std::ranges::find(elements_, matrix) - elements_.begin());
}

int Group::product(int first, int second) const {
    return find(
        multiply(elements_[static_cast<std::size_t>(first)], elements_[static_cast<std::size_t>(second)]));
}

int Group::inverse(int element) const {
    const Matrix& m = elements_[static_cast<std::size_t>(element)];
    return find({m[0], m[2], m[1], m[3]});
}

Offset Group::apply(int element, Offset offset) const {
    const Matrix& m = elements_[static_cast<std::size_t>(element)];
    return {m[0] * offset.row + m[1] * offset.column, m[2] * offset.row + m[3] * offset.column};
}

Representation trivial(const Group& group) {
    return representation(group, 1, [](int, int) { return 0; });
}

Representation regular(const Group& group) {
    return representation(group, group.order(), [&](int g, int h) { return group.product(g, h); });
}

Representation moves(const Group& group) {
    return representation(group, static_cast<int>(kMoves.size()), [&](int g, int move) {
        return static_cast<int>(
            std::ranges::find(kMoves, group.apply(g, kMoves[static_cast<std::size_t>(move)])) -
            kMoves.begin());
    });
}

}  // namespace praxis::learned
