// Novelty against its definition, on random walks.
#include "search/evaluators/novelty.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "tests/search/evaluators/random_task.hpp"

namespace praxis {
namespace {

using Facts = std::set<std::uint32_t>;

/// Sets of facts seen in one partition.
struct Seen {
    Facts facts;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

/// The definition: what sets with a fact of `changed` are new?
Estimate naive_novelty(Seen& seen, const Facts& changed, const Facts& all, int width) {
    Estimate result = width + 1;
    for (const std::uint32_t a : changed) {
        for (const std::uint32_t b : all) {
            if (width < 2 || a == b) continue;
            if (seen.pairs.insert(std::minmax(a, b)).second) result = std::min(result, Estimate{2});
        }
    }
    for (const std::uint32_t a : changed) {
        if (seen.facts.insert(a).second) result = 1;
    }
    return result;
}

TEST(Novelty, IsAsDefined) {
    EXPECT_TRUE(rc::check([] {
        const FiniteDomainTask task = test::random_task();
        const int width = 1 + test::pick(2);
        NoveltyOptions options;
        options.width = width;
        options.forget = *rc::gen::arbitrary<bool>();
        NoveltyEvaluator novelty(task, options);
        std::map<std::int64_t, Seen> seen;
        std::int64_t best = std::numeric_limits<std::int64_t>::max();
        test::State state = task.initial_values;
        const auto visit = [&](const Facts& changed) {
            Facts all;
            for (std::size_t v = 0; v < state.size(); ++v)
                all.insert(task.fact_number({static_cast<std::int32_t>(v), state[v]}));
            const std::int64_t partition = test::pick(4);
            if (options.forget && partition < best) seen.clear();
            best = std::min(best, partition);
            const std::vector<std::int64_t> given{partition};
            novelty.given(given);
            const Estimate expected = naive_novelty(seen[partition], changed, all, width);
            RC_ASSERT(novelty.evaluate(state) == expected);
            return all;
        };
        Facts all;
        for (std::size_t v = 0; v < state.size(); ++v)
            all.insert(task.fact_number({static_cast<std::int32_t>(v), state[v]}));
        novelty.start(StateId(0), state);
        visit(all);
        if (task.operator_count() == 0) return;
        for (int step = 0; step < 30; ++step) {
            const OperatorId op(
                static_cast<std::uint32_t>(test::pick(static_cast<std::int32_t>(task.operator_count()))));
            Facts changed;
            for (const GroundEffect& effect : task.effects[op.index()])
                state[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
            for (const GroundEffect& effect : task.effects[op.index()]) {
                if (state[static_cast<std::size_t>(effect.fact.variable)] == effect.fact.value)
                    changed.insert(task.fact_number(effect.fact));
            }
            novelty.follow(StateId(0), op, StateId(1), state);
            visit(changed);
        }
    }));
}

TEST(Novelty, IsNeverTooNewWithSharedTables) {
    EXPECT_TRUE(rc::check([] {
        FiniteDomainTask task = test::random_task();
        NoveltyOptions small;
        if (*rc::gen::arbitrary<bool>()) {
            small.memory = 64;  // few tables
        } else {
            small.largest_table = 0;  // the field
        }
        NoveltyEvaluator exact(task, {});
        NoveltyEvaluator shared(task, small);
        exact.start(StateId(0), task.initial_values);
        shared.start(StateId(0), task.initial_values);
        for (int step = 0; step < 20; ++step) {
            test::State state = task.initial_values;
            for (std::size_t v = 0; v < state.size(); ++v) state[v] = test::pick(task.domain_sizes[v]);
            const std::vector<std::int64_t> given{test::pick(3)};
            exact.given(given);
            shared.given(given);
            RC_ASSERT(exact.evaluate(state) <= shared.evaluate(state));
        }
    }));
}

}  // namespace
}  // namespace praxis
