// Places for the boxes of a conditional plan's drawing.
#pragma once

#include <cstdint>
#include <vector>

#include "belief/offline/plan_blocks.hpp"

namespace praxis::belief {

/// A box of the drawing: a block, or a leaf that stands for the goal or for a block that is drawn elsewhere.
struct PlanBox {
    enum class Kind : std::uint8_t { block, link, goal };
    Kind kind = Kind::block;
    std::uint32_t block = 0;           ///< block, link
    std::uint32_t parent = 0;          ///< number of the box above; its own for the first
    std::uint32_t choice = 0;          ///< of the parent's block
    std::vector<std::uint32_t> below;  ///< numbers of boxes
    double x = 0, y = 0;               ///< of the upper left corner, in pixels
    double width = 0, height = 0;
};

struct PlanTree {
    std::vector<PlanBox> boxes;  ///< box 0 is the first
    double width = 0, height = 0;
};

inline constexpr double kPlanLine = 15;  ///< height of a line of text, in pixels

/// Every block is drawn where it is first met, from above and from the left.
PlanTree lay_out(const std::vector<PlanBlock>& blocks);

}  // namespace praxis::belief
