#include "tamp/manipulation/join_motions.hpp"

#include <gtest/gtest.h>

#include "tests/tamp/support/planned_motions.hpp"

namespace praxis::tamp {
namespace {

using Pieces = std::vector<MotionPiece>;

Pieces all_pieces(const std::vector<ActionMotion>& motions) {
    Pieces result;
    for (const ActionMotion& motion : motions)
        result.insert(result.end(), motion.pieces.begin(), motion.pieces.end());
    return result;
}

double length(const std::vector<ActionMotion>& motions) {
    double sum = 0;
    for (const MotionPiece& piece : all_pieces(motions))
        if (!piece.path.empty()) sum += path_length(piece.path);
    return sum;
}

/// Where each group is at the end, and which bodies were taken and put where.
struct Effects {
    std::map<int, Configuration> positions;
    std::vector<int> taken;
    std::vector<std::pair<int, Vector3>> put;
    bool operator==(const Effects&) const = default;
};

Effects effects(const std::vector<ActionMotion>& motions) {
    Effects result;
    for (const MotionPiece& piece : all_pieces(motions)) {
        if (!piece.path.empty()) {
            const auto at = result.positions.find(piece.group);
            if (at != result.positions.end()) {
                EXPECT_EQ(at->second, piece.path.front());
            }
            result.positions[piece.group] = piece.path.back();
        }
        if (piece.attach) result.taken.push_back(piece.attach->first);
        if (piece.detach) result.put.emplace_back(piece.detach->first, piece.detach->second.translation());
    }
    return result;
}

class JoinMotions : public testing::TestWithParam<const char*> {
  protected:
    std::vector<ActionMotion> join(std::vector<ActionMotion> motions, const Budget& budget = {}) const {
        return join_motions(*planned.bound.manipulator, *planned.problem.scene.world, std::move(motions),
                            budget);
    }

    SolvedProblem own = SolvedProblem(GetParam(), std::string(GetParam()) == "rooms" ? 6 : 2);
    PlannedMotions planned = PlannedMotions(own);
    std::vector<ActionMotion> before = planned.motions();
};

TEST_P(JoinMotions, AreShorterAndDoTheSame) {
    const std::vector<ActionMotion> joined = join(before);
    ASSERT_EQ(joined.size(), before.size());
    EXPECT_LT(length(joined), length(before));
    EXPECT_LT(all_pieces(joined).size(), all_pieces(before).size());
    EXPECT_EQ(effects(joined), effects(before));
    for (std::size_t i = 0; i < joined.size(); ++i) {
        const auto happens = [](const ActionMotion& motion) {
            return std::ranges::count_if(motion.pieces, [](const MotionPiece& piece) {
                return piece.attach.has_value() || piece.detach.has_value();
            });
        };
        EXPECT_EQ(happens(joined[i]), happens(before[i])) << i;
    }
}

TEST_P(JoinMotions, AreFreeOfCollisions) {
    const std::vector<ActionMotion> joined = join(before);
    for (std::size_t i = 0; i < joined.size(); ++i) planned.actions[i].motion = joined[i];
    EXPECT_EQ(planned.fault(planned.schedule()), "");
}

TEST_P(JoinMotions, JoiningAgainChangesNothing) {
    const std::vector<ActionMotion> joined = join(before);
    EXPECT_LE(length(join(joined)), length(joined));
    EXPECT_EQ(effects(join(joined)), effects(before));
}

TEST_P(JoinMotions, WithoutTimeTheWaysHomeStay) {
    const std::vector<ActionMotion> same = join(before, Budget().limit_wall_time(0));
    EXPECT_LE(length(same), length(before));
    EXPECT_EQ(effects(same), effects(before));
    for (std::size_t i = 0; i < same.size(); ++i) planned.actions[i].motion = same[i];
    EXPECT_EQ(planned.fault(planned.schedule()), "");
}

TEST_P(JoinMotions, OneActionStaysAsItIs) {
    const std::vector<ActionMotion> one = {before.front()};
    EXPECT_EQ(length(join(one)), length(one));
    EXPECT_EQ(all_pieces(join(one)).size(), all_pieces(one).size());
    EXPECT_TRUE(join({}).empty());
}

TEST_P(JoinMotions, ActionsWithoutMotionMayStandBetween) {
    std::vector<ActionMotion> with = before;
    with.insert(with.begin() + 1, ActionMotion{});
    const std::vector<ActionMotion> joined = join(with);
    EXPECT_LE(length(joined), length(before));
    EXPECT_EQ(effects(joined), effects(before));
}

INSTANTIATE_TEST_SUITE_P(Standing, JoinMotions, testing::Values("clutter", "hanoi"),
                         [](const auto& family) { return std::string(family.param); });
INSTANTIATE_TEST_SUITE_P(Mobile, JoinMotions, testing::Values("rooms"),
                         [](const auto& family) { return std::string(family.param); });

}  // namespace
}  // namespace praxis::tamp
