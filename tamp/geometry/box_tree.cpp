#include "tamp/geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace praxis::tamp {

BoxTree::BoxTree(std::span<const AxisBox> boxes) {
    std::vector<std::int32_t> items(boxes.size());
    std::iota(items.begin(), items.end(), 0);
    nodes_.reserve(2 * boxes.size());
    if (!items.empty()) build(boxes, items);
}

void BoxTree::build(std::span<const AxisBox> boxes, std::span<std::int32_t> items) {
    const auto box_of = [&](std::int32_t item) -> const AxisBox& {
        return boxes[static_cast<std::size_t>(item)];
    };
    Node node;
    node.box = box_of(items.front());
    AxisBox centers = {node.box.center(), node.box.center()};
    for (const std::int32_t item : items.subspan(1)) {
        node.box.include(box_of(item));
        centers.include({box_of(item).center(), box_of(item).center()});
    }
    if (items.size() == 1) node.item = items.front();
    const std::size_t place = nodes_.size();
    nodes_.push_back(node);
    if (items.size() > 1) {
        Eigen::Index axis = 0;
        centers.size().maxCoeff(&axis);
        const std::size_t half = items.size() / 2;
        std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                         [&](std::int32_t a, std::int32_t b) {
                             const double left = box_of(a).center()[axis];
                             const double right = box_of(b).center()[axis];
                             return left < right || (left == right && a < b);
                         });
        build(boxes, items.first(half));
        build(boxes, items.subspan(half));
    }
    nodes_[place].end = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace praxis::tamp
