#include "belief/offline/plan_tree.hpp"

#include <algorithm>
#include <string>

namespace praxis::belief {
namespace {

constexpr double kCharacter = 6.7;  // width, of the 11-pixel monospaced font
constexpr double kPadding = 8;
constexpr double kGapAcross = 14;
constexpr double kGapDown = 26;
constexpr double kMargin = 16;
constexpr double kLeafWidth = 70;

double text_width(const std::string& text) {
    return kCharacter * static_cast<double>(text.size());
}

void measure(PlanBox& box, const std::vector<PlanBlock>& blocks) {
    box.width = kLeafWidth;
    box.height = kPlanLine + kPadding;
    if (box.kind != PlanBox::Kind::block) return;
    const auto& actions = blocks[box.block].actions;
    const double number = text_width(" " + std::to_string(box.block + 1));
    for (const std::string& action : actions)
        box.width = std::max(box.width, text_width(action) + number + 2 * kPadding);
    box.height = kPlanLine * static_cast<double>(std::max<std::size_t>(actions.size(), 1)) + kPadding;
}

const std::vector<std::string>& answers(const PlanTree& tree, const PlanBox& box,
                                        const std::vector<PlanBlock>& blocks) {
    return blocks[tree.boxes[box.parent].block].choices[box.choice].answers;
}

}  // namespace

PlanTree lay_out(const std::vector<PlanBlock>& blocks) {
    PlanTree tree;
    if (blocks.empty()) return tree;
    // Boxes in the order in which they are met: breadth first, so that a block is drawn as high up as it
    // occurs.
    std::vector<bool> drawn(blocks.size(), false);
    drawn[0] = true;
    tree.boxes.emplace_back();
    for (std::uint32_t i = 0; i < tree.boxes.size(); ++i) {
        if (tree.boxes[i].kind != PlanBox::Kind::block) continue;
        const PlanBlock& block = blocks[tree.boxes[i].block];
        for (std::uint32_t c = 0; c < block.choices.size(); ++c) {
            const std::uint32_t target = block.choices[c].target;
            PlanBox box;
            box.parent = i;
            box.choice = c;
            box.block = target;
            if (target == PlanBlock::kGoal) {
                box.kind = PlanBox::Kind::goal;
            } else if (drawn[target]) {
                box.kind = PlanBox::Kind::link;
            } else {
                drawn[target] = true;
            }
            tree.boxes[i].below.push_back(static_cast<std::uint32_t>(tree.boxes.size()));
            tree.boxes.push_back(std::move(box));
        }
    }
    // From below: the room that a box and everything under it need.
    std::vector<double> room(tree.boxes.size(), 0);
    for (std::size_t i = tree.boxes.size(); i-- > 0;) {
        PlanBox& box = tree.boxes[i];
        measure(box, blocks);
        room[i] = std::max(room[i] - kGapAcross, box.width);
        if (i == 0) break;
        for (const std::string& answer : answers(tree, box, blocks))
            room[i] = std::max(room[i], text_width(answer) + kPadding);
        room[box.parent] += room[i] + kGapAcross;
    }
    // From above: each box in the middle of its room.
    std::vector<double> left(tree.boxes.size(), kMargin);
    tree.boxes[0].y = kMargin;
    for (std::size_t i = 0; i < tree.boxes.size(); ++i) {
        PlanBox& box = tree.boxes[i];
        box.x = left[i] + (room[i] - box.width) / 2;
        double needed = -kGapAcross;
        for (std::uint32_t below : box.below) needed += room[below] + kGapAcross;
        double next = left[i] + (room[i] - needed) / 2;
        for (std::uint32_t below : box.below) {
            const auto lines = static_cast<double>(answers(tree, tree.boxes[below], blocks).size());
            tree.boxes[below].y = box.y + box.height + kGapDown + kPlanLine * lines;
            left[below] = next;
            next += room[below] + kGapAcross;
        }
        tree.width = std::max(tree.width, left[i] + room[i] + kMargin);
        tree.height = std::max(tree.height, box.y + box.height + kMargin);
    }
    return tree;
}

}  // namespace praxis::belief
