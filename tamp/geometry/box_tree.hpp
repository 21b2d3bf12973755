// Finds those of many fixed boxes that overlap another: a bounding volume hierarchy.
//
// Nodes lie in depth-first order and know where their subtree ends, so that a query walks one array and needs
// no stack. Immutable once made.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tamp/geometry/axis_box.hpp"

namespace praxis::tamp {

class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const AxisBox> boxes);

    bool empty() const { return nodes_.empty(); }
    /// Around all boxes; there must be one.
    const AxisBox& bound() const { return nodes_.front().box; }

    /// Calls `visit(i)` for every box i that overlaps `box`, until it returns true. Whether one did.
    template <class Visit>
    bool any_of(const AxisBox& box, Visit&& visit) const {
        for (std::size_t at = 0; at < nodes_.size();) {
            const Node& node = nodes_[at];
            if (!node.box.overlaps(box)) {
                at = node.end;
                continue;
            }
            if (node.item >= 0 && visit(static_cast<std::size_t>(node.item))) return true;
            ++at;
        }
        return false;
    }

  private:
    struct Node {
        AxisBox box;
        std::uint32_t end = 0;   ///< the first node behind this subtree
        std::int32_t item = -1;  ///< -1: an inner node
    };
    void build(std::span<const AxisBox> boxes, std::span<std::int32_t> items);

    std::vector<Node> nodes_;
};

}  // namespace praxis::tamp
