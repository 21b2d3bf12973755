// The order in which open lists return what was put into them.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>

#include "search/engines/open_list.hpp"

namespace praxis {
namespace {

OpenListPlan sorted_by(std::size_t keys) {
    OpenListPlan plan;
    for (std::size_t i = 0; i < keys; ++i) plan.keys.push_back(Key::heuristic(i));
    return plan;
}

// Pushes and pops at random; a reference keeps entries by key, oldest first.
void compare_with_multimap(std::size_t keys) {
    auto list = make_open_list<StateId>(sorted_by(keys));
    std::map<std::vector<Estimate>, std::vector<StateId>> expected;
    std::uint32_t fresh = 0;
    const auto pop = [&] {
        const auto first = expected.begin();
        RC_ASSERT(!list->empty());
        RC_ASSERT(list->pop() == first->second.front());
        first->second.erase(first->second.begin());
        if (first->second.empty()) expected.erase(first);
    };
    const auto steps = *rc::gen::inRange(1, 400);
    const auto range = *rc::gen::element(3, 50, 100000);
    for (int i = 0; i < steps; ++i) {
        if (expected.empty() || *rc::gen::inRange(0, 3) > 0) {
            std::vector<Estimate> estimates;
            for (std::size_t j = 0; j < keys; ++j) estimates.push_back(*rc::gen::inRange(0, range));
            const StateId id(fresh++);
            RC_ASSERT(list->push({estimates, 0}, id));
            expected[estimates].push_back(id);
        } else {
            pop();
        }
    }
    while (!expected.empty()) pop();
    RC_ASSERT(list->empty());
}

TEST(OpenList, SortsFirstInFirstOut) {
    for (std::size_t keys : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
        EXPECT_TRUE(rc::check([keys] { compare_with_multimap(keys); }));
    }
}

TEST(OpenList, HandsOutSiblingsOneByOne) {
    const std::vector<Estimate> low{1};
    const std::vector<Estimate> high{2};
    auto list = make_open_list<DeferredEntry>(sorted_by(1));
    list->push({high, 0}, {StateId(0), 10, 3});
    list->push({low, 0}, {StateId(1), 20, 2});
    list->push({high, 0}, {StateId(2), 30});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> popped;
    while (!list->empty()) {
        const DeferredEntry entry = list->pop();
        EXPECT_EQ(entry.count, 1u);
        popped.emplace_back(entry.parent.index(), entry.first_operator);
    }
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(popped, (Pairs{{1, 20}, {1, 21}, {0, 10}, {0, 11}, {0, 12}, {2, 30}}));
}

TEST(OpenList, ServesManyEntries) {
    auto list = make_open_list<DeferredEntry>(sorted_by(1));
    constexpr std::uint32_t kCount = 200000;
    for (int round = 0; round < 2; ++round) {
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const std::vector<Estimate> estimates{static_cast<Estimate>(i % 7)};
            list->push({estimates, 0}, {StateId(i), i + 1});
        }
        std::uint32_t last = 0;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const DeferredEntry entry = list->pop();
            ASSERT_EQ(entry.first_operator, entry.parent.index() + 1);
            if (i > 0) {
                ASSERT_LE(last % 7, entry.parent.index() % 7);
                if (last % 7 == entry.parent.index() % 7) {
                    ASSERT_LT(last, entry.parent.index());
                }
            }
            last = entry.parent.index();
        }
        ASSERT_TRUE(list->empty());
    }
}

TEST(OpenList, RefusesWhatItShould) {
    OpenListPlan plan = sorted_by(1);
    plan.preferred_only = true;
    auto preferred = make_open_list<StateId>(plan);
    const std::vector<Estimate> three{3}, dead{kDeadEnd};
    EXPECT_FALSE(preferred->push({three, 0}, StateId(0)));
    EXPECT_TRUE(preferred->push({three, 0, Audience::all_lists}, StateId(1)));
    EXPECT_FALSE(preferred->push({dead, 0, Audience::all_lists}, StateId(2)));
    EXPECT_TRUE(preferred->dead_end({dead, 0}));
    EXPECT_EQ(preferred->pop(), StateId(1));
    EXPECT_TRUE(preferred->empty());

    OpenListPlan pair = sorted_by(2);
    const std::vector<Estimate> first_dead{kDeadEnd, 1}, both_dead{kDeadEnd, kDeadEnd};
    for (bool unsafe : {false, true}) {
        pair.unsafe_pruning = unsafe;
        auto list = make_open_list<StateId>(pair);
        EXPECT_EQ(list->push({first_dead, 0}, StateId(0)), !unsafe);
        EXPECT_FALSE(list->push({both_dead, 0}, StateId(0)));
    }
}

TEST(OpenList, AlternatesAndBoosts) {
    OpenListPlan plan;
    plan.kind = OpenListPlan::Kind::alternation;
    plan.boost = 3;
    plan.lists = {sorted_by(1), sorted_by(1)};
    plan.lists[1].preferred_only = true;
    auto list = make_open_list<StateId>(plan);
    const std::vector<Estimate> low{1}, high{2};
    for (std::uint32_t i = 0; i < 6; ++i) list->push({low, 0}, StateId(i));
    for (std::uint32_t i = 10; i < 20; ++i) list->push({high, 0, Audience::all_lists}, StateId(i));
    std::vector<std::uint32_t> order;
    const auto pop = [&](int count) {
        for (int i = 0; i < count; ++i) order.push_back(list->pop().index());
    };
    pop(4);
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 10, 1, 11}));
    list->boost();
    order.clear();
    pop(5);
    EXPECT_EQ(order, (std::vector<std::uint32_t>{12, 13, 14, 2, 15}));
}

TEST(OpenList, TypesAreEquallyLikely) {
    OpenListPlan plan = sorted_by(1);
    plan.kind = OpenListPlan::Kind::type_based;
    plan.seed = 5;
    const std::vector<Estimate> common{1}, rare{2};
    int rare_first = 0;
    std::vector<std::uint32_t> popped;
    auto list = make_open_list<StateId>(plan);
    for (int round = 0; round < 400; ++round) {
        for (std::uint32_t i = 0; i < 20; ++i) list->push({common, 0}, StateId(i));
        list->push({rare, 0}, StateId(99));
        popped.clear();
        while (!list->empty()) popped.push_back(list->pop().index());
        if (popped[0] == 99) ++rare_first;
        std::sort(popped.begin(), popped.end());
        ASSERT_EQ(popped.size(), 21u);
        for (std::uint32_t i = 0; i < 20; ++i) ASSERT_EQ(popped[i], i);
    }
    EXPECT_GT(rare_first, 150);
    EXPECT_LT(rare_first, 250);
}

TEST(Key, IsALinearFormWithMaxima) {
    const std::vector<Estimate> estimates{3, 10, kDeadEnd};
    const Evaluated state{estimates, 5};
    const Key h0 = Key::heuristic(0), h1 = Key::heuristic(1), dead = Key::heuristic(2),
              g = Key::cost_so_far();
    EXPECT_EQ(Key::sum({g, Key::weighted(h0, 4)}).value(state), 17);
    EXPECT_EQ(Key::weighted(Key::maximum({h0, h1, Key::constant(2)}), 2).value(state), 20);
    EXPECT_EQ(Key::sum({g, Key::maximum({Key::sum({h0, g}), Key::constant(9)})}).value(state), 14);
    EXPECT_EQ(Key::sum({g, dead}).value(state), kInfiniteKey);
    EXPECT_EQ(Key::weighted(dead, 0).value(state), 0);
    EXPECT_EQ(Key::weighted(Key::weighted(h1, 1'000'000'000), 1'000'000'000).value(state), kInfiniteKey - 1);
    EXPECT_TRUE(Key::maximum({h0, g}).uses_g());
    EXPECT_FALSE(Key::maximum({h0, h1}).uses_g());
    EXPECT_TRUE(Key::maximum({h0, h1}).admissible({true, true, false}));
    EXPECT_FALSE(Key::maximum({h0, dead}).admissible({true, true, false}));
    EXPECT_FALSE(Key::sum({h0, h1}).admissible({true, true, true}));
    EXPECT_FALSE(Key::weighted(h0, 2).admissible({true, true, true}));
    EXPECT_FALSE(Key::constant(1).admissible({}));
    EXPECT_TRUE(Key::constant(0).admissible({}));
}

}  // namespace
}  // namespace praxis
