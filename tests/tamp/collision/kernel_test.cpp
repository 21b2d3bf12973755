#include "tamp/collision/kernel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <set>
#include <vector>

#include "tamp/collision/kernel_model.hpp"
#include "tests/tamp/support/ball_arm.hpp"

namespace praxis::tamp {
namespace {

constexpr int kLanes = kernel::kLanes;

struct alignas(32) Eight {
    std::array<float, kLanes> v;
};

/// Points in blocks of eight, as the kernel wants them.
std::vector<Eight> blocks_of(const std::vector<std::vector<float>>& points, int dimension) {
    const std::size_t count = (points.size() + kLanes - 1) / kLanes;
    std::vector<Eight> blocks(count * static_cast<std::size_t>(dimension));
    for (Eight& block : blocks) block.v.fill(1e17F);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t d = 0; d < points[i].size(); ++d) {
            blocks[i / kLanes * points[i].size() + d].v[i % kLanes] = points[i][d];
        }
    }
    return blocks;
}

float squared_distance(const std::vector<float>& a, const std::vector<float>& b, float period) {
    float sum = 0;
    for (std::size_t d = 0; d < a.size(); ++d) {
        float difference = a[d] - b[d];
        if (d == 0 && period > 0) difference -= period * std::round(difference / period);
        sum += difference * difference;
    }
    return sum;
}

void check_nearest(const kernel::Functions& functions, float period) {
    Random random(1);
    const auto point = [&] {
        std::vector<float> numbers;
        for (int d = 0; d < 5; ++d) numbers.push_back(static_cast<float>(uniform(random, -3, 3)));
        return numbers;
    };
    std::vector<std::vector<float>> points;
    for (int count = 1; count < 60; ++count) {
        points.push_back(point());
        const std::vector<float> query = point();
        const std::array<float, 5> periods = {period, 0, 0, 0, 0};
        float squared = -1;
        const std::vector<Eight> blocks = blocks_of(points, 5);
        const int found = functions.nearest(blocks.front().v.data(), static_cast<int>(blocks.size()) / 5, 5,
                                            query.data(), period > 0 ? periods.data() : nullptr, &squared);
        ASSERT_GE(found, 0);
        ASSERT_LT(found, count);
        float best = 1e30F;
        for (const std::vector<float>& p : points) best = std::min(best, squared_distance(p, query, period));
        EXPECT_NEAR(squared, best, 1e-4F);
        EXPECT_NEAR(squared_distance(points[static_cast<std::size_t>(found)], query, period), best, 1e-4F);
    }
}

TEST(Kernel, TheNearestPointIsFound) {
    check_nearest(kernel::functions(), 0);
    check_nearest(kernel::portable_functions(), 0);
}

TEST(Kernel, TheNearestPointIsFoundModuloAPeriod) {
    check_nearest(kernel::functions(), 2);
    check_nearest(kernel::portable_functions(), 2);
}

TEST(Kernel, EveryRakeComesOnceAndTheLastFirst) {
    for (int rakes = 1; rakes < 40; ++rakes) {
        std::set<int> seen;
        for (int i = 0; i < kernel::rake_turns(rakes); ++i) {
            const int rake = kernel::rake_at(i, rakes);
            EXPECT_TRUE(rake < 0 || seen.insert(rake).second);
        }
        EXPECT_EQ(static_cast<int>(seen.size()), rakes);
        EXPECT_EQ(kernel::rake_at(0, rakes), rakes - 1);
    }
}

/// A model and the memory that its functions need.
struct Prepared {
    SolidCache cache = {};
    KernelModel model;
    kernel::Model view;
    std::vector<Eight> scratch;

    explicit Prepared(const CollisionProblem& problem, BallSide side = BallSide::outer)
        : model(problem, side, cache),
          view(model.view()),
          scratch(static_cast<std::size_t>(kernel::scratch_size(view) / kLanes)) {}

    unsigned collisions(const kernel::Functions& functions, const std::vector<Eight>& positions) {
        return functions.collisions(view, positions.front().v.data(), scratch.front().v.data());
    }
};

CollisionProblem arm_problem(std::uint64_t seed) {
    const auto robot = ball_arm();
    Random random(seed);
    return {robot, std::make_shared<const World>(random_world(random, 12)), 0, robot->zero()};
}

std::vector<Eight> random_block(const Robot& robot, Random& random) {
    std::vector<Eight> block(robot.groups[0].variables.size());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const Configuration positions = random_positions(robot, robot.groups[0], random);
        for (std::size_t v = 0; v < positions.size(); ++v)
            block[v].v[lane] = static_cast<float>(positions[v]);
    }
    return block;
}

TEST(Kernel, ItsVersionsAgreeButForRounding) {
    const CollisionProblem problem = arm_problem(1);
    Prepared prepared(problem);
    Random random(2);
    int differing = 0;
    unsigned ever = 0;
    unsigned always = 0xff;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<Eight> block = random_block(*problem.robot, random);
        const unsigned mask = prepared.collisions(kernel::functions(), block);
        differing += std::popcount(mask ^ prepared.collisions(kernel::portable_functions(), block));
        ever |= mask;
        always &= mask;
    }
    EXPECT_LE(differing, 2);
    EXPECT_EQ(ever, 0xffU);
    EXPECT_EQ(always, 0U);
}

/// Inner balls are smaller by twice the margin: what the kernel errs by must lie between.
TEST(Kernel, OneVersionsInnerContactsAreTheOthersOuterOnes) {
    const CollisionProblem problem = arm_problem(3);
    Prepared outer(problem);
    Prepared inner(problem, BallSide::inner);
    EXPECT_GT(outer.model.margin(), 1e-6);
    EXPECT_LT(outer.model.margin(), 5e-5);
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
        const std::vector<Eight> block = random_block(*problem.robot, random);
        const unsigned sure = inner.collisions(kernel::functions(), block);
        EXPECT_EQ(sure & ~outer.collisions(kernel::portable_functions(), block), 0U);
        const unsigned portably_sure = inner.collisions(kernel::portable_functions(), block);
        EXPECT_EQ(portably_sure & ~outer.collisions(kernel::functions(), block), 0U);
    }
}

TEST(Kernel, EveryLaneIsLookedAtByItself) {
    const CollisionProblem problem = arm_problem(5);
    Prepared prepared(problem);
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const std::vector<Eight> block = random_block(*problem.robot, random);
        const unsigned mask = prepared.collisions(kernel::functions(), block);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            std::vector<Eight> alone = block;
            for (Eight& numbers : alone) numbers.v.fill(numbers.v[lane]);
            const unsigned expected = (mask >> lane & 1U) != 0 ? 0xffU : 0U;
            EXPECT_EQ(prepared.collisions(kernel::functions(), alone), expected);
        }
    }
}

}  // namespace
}  // namespace praxis::tamp
