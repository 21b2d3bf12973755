// Tuple stores against sets and maps of the standard library.
#include "search/ground/tuple_store.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <optional>
#include <set>

namespace praxis::grounding {
namespace {

using Tuple = std::vector<Object>;

constexpr Object kObjects = 12;

/// Each column takes some of the objects.
struct Columns {
    explicit Columns(std::size_t arity) : positions(arity) {
        for (auto& position : positions) {
            position.assign(kObjects, kNoRow);
            std::uint32_t next = 0;
            for (Object object = 0; object < kObjects; ++object)
                if (*rc::gen::inRange(0, 4) != 0) position[object] = next++;
            ranges.push_back({&position, next});
        }
    }
    std::vector<std::vector<std::uint32_t>> positions;
    std::vector<ColumnRange> ranges;
};

/// Tuples inside the ranges, or anything.
Tuple any_tuple(const Columns& columns, bool inside) {
    Tuple tuple;
    for (const auto& position : columns.positions) {
        Object object = *rc::gen::inRange(Object{0}, kObjects);
        for (Object i = 0; inside && i < kObjects && position[object] == kNoRow; ++i)
            object = (object + 1) % kObjects;
        tuple.push_back(object);
    }
    return tuple;
}

TEST(TupleStore, FindsWhatWasInserted) {
    bool met_dense = false, met_hashed = false, left_dense = false;
    const auto once = [&] {
        const auto arity = *rc::gen::inRange<std::size_t>(0, 4);
        const Columns columns(arity);
        TupleStore store(columns.ranges, *rc::gen::element<std::size_t>(0, 10, 100000));
        const bool dense_at_first = store.dense_entries() > 0;
        const int strays = *rc::gen::element(0, 0, 20);
        std::map<Tuple, Row> expected;
        for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
            const Tuple tuple = any_tuple(columns, *rc::gen::inRange(0, 100) >= strays);
            const auto [known, fresh] = expected.try_emplace(tuple, static_cast<Row>(expected.size()));
            RC_ASSERT(store.insert(tuple.data()) == std::pair(known->second, fresh));
            RC_ASSERT(store.size() == expected.size());
        }
        for (int i = 0; i < 20; ++i) {
            const Tuple tuple = any_tuple(columns, false);
            const auto known = expected.find(tuple);
            RC_ASSERT(store.find(tuple.data()) == (known == expected.end() ? kNoRow : known->second));
        }
        for (const auto& [tuple, row] : expected) {
            RC_ASSERT(store.find(tuple.data()) == row);
            RC_ASSERT(std::equal(tuple.begin(), tuple.end(), store.row(row)));
        }
        for (std::uint32_t c = 0; c < arity; ++c) {
            std::set<Object> values;
            for (const auto& [tuple, row] : expected) values.insert(tuple[c]);
            RC_ASSERT(store.distinct(c) == std::max<std::size_t>(values.size(), 1));
        }
        met_dense |= store.dense_entries() > 0;
        met_hashed |= !dense_at_first;
        left_dense |= dense_at_first && store.dense_entries() == 0;
    };
    EXPECT_TRUE(rc::check([&] {
        for (int round = 0; round < 10; ++round) once();
    }));
    EXPECT_TRUE(met_dense);
    EXPECT_TRUE(met_hashed);
    EXPECT_TRUE(left_dense);
}

std::multiset<Tuple> rows_in(const TupleStore& store, std::uint32_t index, const Tuple& key) {
    std::multiset<Tuple> rows;
    std::optional<Row> last;
    for (Row row = store.first_in(index, key.data()); row != kNoRow; row = store.next_in(index, row)) {
        RC_ASSERT(!last || row < *last);  // newest first
        last = row;
        rows.emplace(store.row(row), store.row(row) + store.arity());
    }
    return rows;
}

TEST(TupleStore, IndicesListThePublishedRows) {
    EXPECT_TRUE(rc::check([] {
        const auto arity = *rc::gen::inRange<std::size_t>(1, 4);
        const Columns columns(arity);
        TupleStore store(columns.ranges, *rc::gen::element<std::size_t>(0, 100000));
        const bool append_only = *rc::gen::inRange(0, 4) == 0;
        std::set<Tuple> met;
        std::vector<Tuple> inserted;
        std::map<std::vector<std::uint32_t>, std::uint32_t> indices;
        for (int i = *rc::gen::inRange(0, 80); i > 0; --i) {
            switch (*rc::gen::inRange(0, 8)) {
                case 0: {
                    std::vector<std::uint32_t> chosen;
                    for (std::uint32_t c = 0; c < arity; ++c)
                        if (*rc::gen::arbitrary<bool>()) chosen.push_back(c);
                    if (chosen.empty()) break;
                    const std::uint32_t index = store.index_on(chosen);
                    RC_ASSERT(indices.try_emplace(chosen, index).first->second == index);
                    break;
                }
                case 1:
                    store.publish(*rc::gen::inRange(store.published(), store.size() + 1));
                    break;
                default: {
                    const Tuple tuple = any_tuple(columns, true);
                    if (!met.insert(tuple).second) break;
                    inserted.push_back(tuple);
                    append_only ? store.append(tuple.data()) : void(store.insert(tuple.data()));
                }
            }
        }
        for (const auto& [chosen, index] : indices) {
            for (int i = 0; i < 10; ++i) {
                const Tuple tuple = any_tuple(columns, *rc::gen::inRange(0, 3) != 0);
                Tuple key;
                for (const std::uint32_t c : chosen) key.push_back(tuple[c]);
                std::multiset<Tuple> expected;
                for (Row row = 0; row < store.published(); ++row) {
                    const auto agrees = [&](std::uint32_t c) { return inserted[row][c] == tuple[c]; };
                    if (std::all_of(chosen.begin(), chosen.end(), agrees)) expected.insert(inserted[row]);
                }
                RC_ASSERT(rows_in(store, index, key) == expected);
            }
        }
    }));
}

}  // namespace
}  // namespace praxis::grounding
