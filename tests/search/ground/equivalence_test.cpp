// Random lifted tasks and their groundings, state by state.
#include "tests/search/ground/equivalence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>

#include "tests/search/ground/moving_task.hpp"
#include "tests/search/support/random_task.hpp"

namespace praxis {
namespace {

/// How many tasks were of which kind.
struct Shares {
    std::size_t tasks = 0, states = 0, complete = 0, solvable = 0, proved_unsolvable = 0, derived = 0,
                conditional = 0, multi_valued = 0, shadowed = 0, mutex_groups = 0;

    void count(const test::Equivalence& one) {
        ++tasks;
        states += one.states;
        complete += one.complete;
        solvable += one.solvable;
        proved_unsolvable += one.proved_unsolvable;
        derived += one.derived;
        conditional += one.conditional;
        multi_valued += one.multi_valued;
        shadowed += one.shadowed;
        mutex_groups += one.mutex_groups;
    }

    void print(const char* name) const {
        std::cout << name << ": " << tasks << " tasks, " << states << " states, complete " << complete
                  << ", solvable " << solvable << ", unsolvable by grounding " << proved_unsolvable
                  << ", axioms " << derived << ", conditional effects " << conditional << ", multi-valued "
                  << multi_valued << ", shadows " << shadowed << ", mutex groups " << mutex_groups << "\n";
    }

    /// At least this percentage.
    bool at_least(std::size_t part, std::size_t percent) const { return part * 100 >= percent * tasks; }
};

constexpr std::uint32_t kTasksPerRun = 10;

std::uint32_t any_seed() {
    return *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
}

TEST(GroundEquivalence, TasksWithAnyFormula) {
    Shares shares;
    ASSERT_TRUE(rc::check([&] {
        const std::uint32_t first = any_seed();
        for (std::uint32_t seed = first; seed != first + kTasksPerRun; ++seed) {
            const test::RandomTask random = test::random_task(seed);
            const test::Equivalence result = test::compare(random.task, 30);
            if (!result.difference.empty()) RC_LOG() << "random_task(" << seed << ")";
            RC_ASSERT(result.difference == "");
            shares.count(result);
        }
    }));
    shares.print("any formula");
    EXPECT_TRUE(shares.at_least(shares.solvable, 20));
    EXPECT_TRUE(shares.at_least(shares.derived, 8));
    EXPECT_TRUE(shares.at_least(shares.conditional, 4));
}

TEST(GroundEquivalence, TasksWhereThingsMove) {
    Shares shares;
    ASSERT_TRUE(rc::check([&] {
        const std::uint32_t first = any_seed();
        for (std::uint32_t seed = first; seed != first + kTasksPerRun; ++seed) {
            const test::MovingTask random = test::moving_task(seed);
            const test::Equivalence result = test::compare(*random.task, 60);
            if (!result.difference.empty())
                RC_LOG() << "moving_task(" << seed << ")\n" << random.domain << "\n" << random.problem;
            RC_ASSERT(result.difference == "");
            shares.count(result);
        }
    }));
    shares.print("moving things");
    EXPECT_TRUE(shares.at_least(shares.solvable, 20));
    EXPECT_TRUE(shares.at_least(shares.derived, 20));
    EXPECT_TRUE(shares.at_least(shares.conditional, 20));
    EXPECT_TRUE(shares.at_least(shares.multi_valued, 15));
}

}  // namespace
}  // namespace praxis
