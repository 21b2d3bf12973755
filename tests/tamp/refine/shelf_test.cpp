// What is learned from blamed atoms of the state.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <deque>
#include <set>

#include "search/engines/random.hpp"
#include "tests/tamp/support/shelf_world.hpp"

namespace praxis::tamp {
namespace {

using test::ShelfWorld;

struct Solved {
    Refinement refinement;
    std::vector<int> cells;  ///< by item, at the end; -1: held
    std::set<int> moved;
};

Solved solve(const ShelfWorld& world, const RefineOptions& options = {}, const Budget& budget = {}) {
    const StreamTask task = world.task();
    const StreamLibrary library = world.library();
    Solved result{refine({&task, &library, world.values(), options}, budget), world.start, {}};
    if (!result.refinement.plan) return result;
    for (const RefinedStep& step : result.refinement.plan->steps) {
        const auto item = static_cast<std::size_t>(std::stoi(step.arguments[0].name().substr(1)));
        const int cell = std::stoi(step.arguments[1].name().substr(1));
        const auto in_front = [&](int other) {
            return other >= 0 && other / world.depths == cell / world.depths &&
                   other % world.depths < cell % world.depths;
        };
        EXPECT_TRUE(std::ranges::none_of(result.cells, in_front));
        EXPECT_FALSE(world.is_walled(step.arguments[1].get<test::Cell>()));
        EXPECT_EQ(result.cells[item], step.name == "take" ? cell : -1);
        if (step.name == "put") {
            EXPECT_EQ(std::ranges::count(result.cells, cell), 0);
        }
        result.cells[item] = step.name == "take" ? -1 : cell;
        result.moved.insert(static_cast<int>(item));
    }
    EXPECT_EQ(result.cells[static_cast<std::size_t>(world.target)], -1);
    return result;
}

/// Whether a sequence of takes and puts ends with the target in the hand: all states are visited.
bool solvable(const ShelfWorld& world) {
    std::set<std::vector<int>> seen{world.start};
    std::deque<std::vector<int>> open{world.start};
    const auto reachable = [&](const std::vector<int>& cells, int cell) {
        if (std::ranges::count(world.walled, cell) > 0) return false;
        return std::ranges::none_of(cells, [&](int other) {
            return other >= 0 && other / world.depths == cell / world.depths &&
                   other % world.depths < cell % world.depths;
        });
    };
    while (!open.empty()) {
        std::vector<int> cells = open.front();
        open.pop_front();
        if (cells[static_cast<std::size_t>(world.target)] == -1) return true;
        const auto push = [&](const std::vector<int>& next) {
            if (seen.insert(next).second) open.push_back(next);
        };
        const auto held = std::ranges::find(cells, -1);
        if (held != cells.end()) {
            for (int c = 0; c < world.rows * world.depths; ++c) {
                if (std::ranges::count(cells, c) > 0 || !reachable(cells, c)) continue;
                std::vector<int> next = cells;
                next[static_cast<std::size_t>(held - cells.begin())] = c;
                push(next);
            }
            continue;
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!reachable(cells, cells[i])) continue;
            std::vector<int> next = cells;
            next[i] = -1;
            push(next);
        }
    }
    return false;
}

ShelfWorld random_world(std::uint64_t seed) {
    Random random(seed);
    ShelfWorld world;
    world.rows = 1 + static_cast<int>(random.below(3));
    world.depths = 1 + static_cast<int>(random.below(3));
    std::vector<int> cells;
    for (int c = 0; c < world.rows * world.depths; ++c) cells.push_back(c);
    random.shuffle(cells);
    const std::size_t items = 1 + random.below(std::min<std::size_t>(cells.size(), 4));
    world.start.assign(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(items));
    for (const int c : cells)
        if (random.below(4) == 0) world.walled.push_back(c);
    return world;
}

RC_GTEST_PROP(Shelf, AgreesWithAllStatesOfSmallShelves, ()) {
    const ShelfWorld world = random_world(*rc::gen::arbitrary<std::uint64_t>());
    const Solved solved = solve(world);
    RC_ASSERT(solved.refinement.status ==
              (solvable(world) ? RefineStatus::solved : RefineStatus::infeasible));
}

TEST(Shelf, OnlyWhatIsInTheWayIsMoved) {
    for (int blockers = 0; blockers <= 4; ++blockers) {
        ShelfWorld world;
        world.rows = 4;
        world.depths = 9;
        for (int i = 0; i <= blockers; ++i) world.start.push_back(i);
        world.target = blockers;
        for (int i = 0; i < 5; ++i) world.start.push_back(3 * world.depths + i);
        const Solved solved = solve(world);
        ASSERT_EQ(solved.refinement.status, RefineStatus::solved);
        EXPECT_EQ(solved.moved.size(), static_cast<std::size_t>(blockers) + 1);
    }
}

TEST(Shelf, ABlockerThatCannotBeMovedIsTheReason) {
    ShelfWorld world;
    world.rows = 3;
    world.depths = 3;
    world.start = {2, 1, 4};
    world.walled = {1};
    const Solved solved = solve(world);
    EXPECT_EQ(solved.refinement.status, RefineStatus::infeasible);
    const auto says = [&](const std::string& part) {
        return std::ranges::any_of(solved.refinement.reasons, [&](const std::string& reason) {
            return reason.find(part) != std::string::npos;
        });
    };
    EXPECT_TRUE(says("(take i0 c2"));
    EXPECT_TRUE(says("while (at i1 c1)"));
    EXPECT_TRUE(says("(take i1 c1"));
    EXPECT_FALSE(says("i2"));
}

TEST(Shelf, IndefiniteRejectionsProveNothing) {
    ShelfWorld world;
    world.rows = 1;
    world.depths = 2;
    world.start = {1, 0};
    world.walled = {0};
    EXPECT_EQ(solve(world).refinement.status, RefineStatus::infeasible);
    world.walled = {};
    world.rows = 1;
    EXPECT_EQ(solve(world).refinement.status, RefineStatus::infeasible) << "nowhere to put the blocker";
    world.definite = false;
    Budget budget;
    budget.limit_wall_time(0.3);
    EXPECT_EQ(solve(world, {}, budget).refinement.status, RefineStatus::out_of_budget);
}

TEST(Shelf, BlameSavesSearches) {
    ShelfWorld world;
    world.rows = 3;
    world.depths = 4;
    world.start = {0, 1, 2, 3, 8};
    world.target = 3;
    RefineOptions options;
    const Solved on = solve(world, options);
    ASSERT_EQ(on.refinement.status, RefineStatus::solved);
    options.nogoods = false;
    Budget budget;
    budget.limit_wall_time(1);
    const Solved off = solve(world, options, budget);
    EXPECT_GT(off.refinement.statistics.searches, 2 * on.refinement.statistics.searches);
}

TEST(Shelf, JointBlameIsWeakerAndStillRight) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        ShelfWorld world = random_world(seed);
        world.each = false;
        const bool possible = solvable(world);
        EXPECT_EQ(solve(world).refinement.status, possible ? RefineStatus::solved : RefineStatus::infeasible);
        RefineOptions options;
        options.backjumping = false;
        EXPECT_NE(solve(world, options).refinement.status,
                  possible ? RefineStatus::infeasible : RefineStatus::solved);
    }
}

}  // namespace
}  // namespace praxis::tamp
