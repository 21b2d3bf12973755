#include "search/evaluators/cost_queue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

namespace praxis {
namespace {

RC_GTEST_PROP(CostQueue, PopsTheSmallestKey, ()) {
    CostQueue queue;
    for (int round = 0; round < 3; ++round) {
        queue.clear();
        std::multimap<std::int32_t, std::uint32_t> expected;
        const std::int32_t largest = *rc::gen::element(5, 1000, 40000, 1 << 30);
        for (int step = *rc::gen::inRange(0, 300); step > 0; --step) {
            if (*rc::gen::inRange(0, 3) > 0) {
                const std::int32_t key = *rc::gen::inRange(0, largest);
                const auto item = static_cast<std::uint32_t>(step);
                queue.push(key, item);
                expected.emplace(key, item);
                continue;
            }
            CostQueue::Entry entry{};
            const bool found = queue.pop(entry);
            RC_ASSERT(found == !expected.empty());
            if (!found) continue;
            RC_ASSERT(entry.key == expected.begin()->first);
            const auto [first, last] = expected.equal_range(entry.key);
            const auto place =
                std::find_if(first, last, [&](const auto& e) { return e.second == entry.item; });
            RC_ASSERT(place != last);
            expected.erase(place);
        }
    }
}

RC_GTEST_PROP(CostQueue, PopsAllOfTheSmallestKey, ()) {
    CostQueue queue;
    for (int round = 0; round < 3; ++round) {
        queue.clear();
        std::map<std::int32_t, std::multiset<std::uint32_t>> expected;
        const std::int32_t largest = *rc::gen::element(5, 1000, 40000, 1 << 30);
        for (int step = *rc::gen::inRange(0, 300); step > 0; --step) {
            if (*rc::gen::inRange(0, 5) > 0) {
                const std::int32_t key = *rc::gen::inRange(0, largest);
                const auto item = static_cast<std::uint32_t>(step);
                queue.push(key, item);
                expected[key].insert(item);
                continue;
            }
            std::int32_t key = 0;
            RC_ASSERT(queue.smallest(key) == !expected.empty());
            if (expected.empty()) continue;
            RC_ASSERT(key == expected.begin()->first);
            std::multiset<std::uint32_t> items;
            queue.pop_all(key, [&](std::uint32_t item) { items.insert(item); });
            RC_ASSERT(items == expected.begin()->second);
            expected.erase(expected.begin());
        }
    }
}

}  // namespace
}  // namespace praxis
