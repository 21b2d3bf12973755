// Packed states and where they are kept.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <unordered_map>

#include "search/state/state_packer.hpp"
#include "search/state/state_registry.hpp"
#include "tests/search/state/random_task.hpp"

namespace praxis {
namespace {

using test::add_variable;
using test::at;
using test::Values;

FiniteDomainTask task_of_domains(const std::vector<std::int32_t>& sizes) {
    FiniteDomainTask task;
    for (std::int32_t size : sizes) add_variable(task, size, 0);
    return task;
}

rc::Gen<std::vector<std::int32_t>> domains() {
    return rc::gen::container<std::vector<std::int32_t>>(
        rc::gen::oneOf(rc::gen::inRange(1, 6), rc::gen::inRange(1, 70000), rc::gen::just(2147483647)));
}

TEST(StatePacker, ReturnsWhatWasPacked) {
    EXPECT_TRUE(rc::check([] {
        const auto sizes = *domains();
        const FiniteDomainTask task = task_of_domains(sizes);
        const StatePacker packer(task);
        Values values, read(sizes.size(), -1);
        for (std::int32_t size : sizes) values.push_back(*rc::gen::inRange(0, size));
        std::vector<std::uint32_t> words(packer.word_count(), 0xdeadbeef);
        packer.pack(values.data(), words.data());
        packer.unpack(words.data(), read.data());
        RC_ASSERT(read == values);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            RC_ASSERT(packer.get(words.data(), static_cast<std::int32_t>(i)) == values[i]);
        }
    }));
}

TEST(StatePacker, SetChangesOneVariable) {
    EXPECT_TRUE(rc::check([] {
        const auto sizes = *rc::gen::nonEmpty(domains());
        const FiniteDomainTask task = task_of_domains(sizes);
        const StatePacker packer(task);
        Values values, read(sizes.size(), -1);
        for (std::int32_t size : sizes) values.push_back(*rc::gen::inRange(0, size));
        std::vector<std::uint32_t> words(packer.word_count());
        packer.pack(values.data(), words.data());
        const auto variable = static_cast<std::int32_t>(*rc::gen::inRange<std::size_t>(0, sizes.size()));
        values[at(variable)] = *rc::gen::inRange(0, sizes[at(variable)]);
        packer.set(words.data(), {variable, values[at(variable)]});
        packer.unpack(words.data(), read.data());
        RC_ASSERT(read == values);
        std::vector<std::uint32_t> fresh(packer.word_count());
        packer.pack(values.data(), fresh.data());
        RC_ASSERT(fresh == words);
    }));
}

TEST(StatePacker, WastesNoWords) {
    EXPECT_EQ(StatePacker(task_of_domains({})).word_count(), 1u);
    EXPECT_EQ(StatePacker(task_of_domains(std::vector<std::int32_t>(32, 2))).word_count(), 1u);
    EXPECT_EQ(StatePacker(task_of_domains(std::vector<std::int32_t>(33, 2))).word_count(), 2u);
    // 17 and 15 bits, 16 and 16 bits.
    EXPECT_EQ(StatePacker(task_of_domains({1 << 16, 1 << 17, 1 << 15, 1 << 16})).word_count(), 2u);
}

TEST(StatePacker, LeavesDerivedVariablesAlone) {
    FiniteDomainTask task;
    add_variable(task, 2, 0, 0);
    add_variable(task, 5, 3);
    const StatePacker packer(task);
    Values values{1, 4}, read{7, 7};
    std::uint32_t word = 0;
    packer.pack(values.data(), &word);
    packer.unpack(&word, read.data());
    EXPECT_EQ(read, (Values{7, 4}));
}

TEST(RecordPool, KeepsAddresses) {
    for (std::size_t words : {std::size_t{1}, std::size_t{3}, std::size_t{1000}, std::size_t{300000}}) {
        RecordPool pool(words);
        std::vector<std::uint32_t*> places;
        const std::uint32_t count = words < 1000 ? 400000 : words < 300000 ? 2000 : 5;
        for (std::uint32_t i = 0; i < count; ++i) {
            places.push_back(pool.next());
            pool.next()[0] = i;
            pool.next()[words - 1] = i;
            pool.commit();
        }
        ASSERT_EQ(pool.size(), count);
        for (std::uint32_t i = 0; i < count; ++i) {
            ASSERT_EQ(pool[i], places[i]);
            ASSERT_EQ(pool[i][0], i);
            ASSERT_EQ(pool[i][words - 1], i);
        }
    }
}

// The contents are in a vector; `hash` may be as bad as it likes.
template <class Hash>
void compare_with_map(const std::vector<std::uint64_t>& inserted, const Hash& hash) {
    StateSet set;
    std::vector<std::uint64_t> contents;
    std::unordered_map<std::uint64_t, std::uint32_t> expected;
    for (std::uint64_t content : inserted) {
        const auto fresh = static_cast<std::uint32_t>(contents.size());
        const auto [id, added] = set.insert(
            hash(content), fresh, [&](std::uint32_t other) { return contents[other] == content; },
            [&](std::uint32_t other) { return hash(contents[other]); }, [](std::uint32_t) {});
        const auto [known, new_here] = expected.try_emplace(content, fresh);
        ASSERT_EQ(added, new_here);
        ASSERT_EQ(id, known->second);
        if (added) contents.push_back(content);
    }
}

TEST(StateSet, IsASet) {
    std::mt19937_64 random(1);
    std::vector<std::uint64_t> inserted;
    for (int i = 0; i < 300000; ++i) inserted.push_back(random() % 100000);
    compare_with_map(inserted, [](std::uint64_t content) {
        const std::uint32_t words[2] = {static_cast<std::uint32_t>(content), 7};
        return hash_words(words, 2);
    });
}

TEST(StateSet, StandsBadHashes) {
    std::vector<std::uint64_t> inserted;
    for (std::uint64_t i = 0; i < 3000; ++i) inserted.push_back(i * i % 1000);
    compare_with_map(inserted, [](std::uint64_t) { return std::uint64_t{0xffffffffffffffff}; });
    compare_with_map(inserted, [](std::uint64_t content) { return content % 3; });
}

TEST(StateSet, TakesLittleMemory) {
    StateSet set;
    const auto hash = [](std::uint32_t i) { return hash_words(&i, 1); };
    for (std::uint32_t i = 0; i < 2000000; ++i) {
        set.insert(
            hash(i), i, [&](std::uint32_t other) { return other == i; }, hash, [](std::uint32_t) {});
        if (i > 50000 && i % 1000 == 0) {
            ASSERT_LT(static_cast<double>(set.memory()) / i, 9.5);
        }
    }
}

TEST(HashWords, TellsSimilarStatesApart) {
    for (std::size_t length = 1; length <= 9; ++length) {
        std::set<std::uint64_t> hashes;
        std::size_t count = 0;
        for (std::size_t bit = 0; bit < 32 * length; ++bit) {
            for (std::size_t other = bit; other < 32 * length; ++other) {
                std::vector<std::uint32_t> words(length, 0);
                words[bit / 32] ^= 1u << bit % 32;
                if (other != bit) words[other / 32] ^= 1u << other % 32;
                hashes.insert(hash_words(words.data(), length));
                ++count;
            }
        }
        EXPECT_EQ(hashes.size(), count);
    }
}

TEST(StateRegistry, NumbersStatesByDiscovery) {
    const FiniteDomainTask task = task_of_domains({1000, 1000, 1000, 1000});
    const StatePacker packer(task);
    StateRegistry registry(packer, 2);
    std::map<Values, std::uint32_t> expected;
    std::mt19937_64 random(3);
    for (int i = 0; i < 50000; ++i) {
        Values values;
        for (int j = 0; j < 4; ++j) values.push_back(static_cast<std::int32_t>(random() % 12) * 83);
        packer.pack(values.data(), registry.candidate());
        const auto [id, is_new] = registry.intern();
        const auto [known, added] = expected.try_emplace(values, static_cast<std::uint32_t>(expected.size()));
        ASSERT_EQ(is_new, added);
        ASSERT_EQ(id.index(), known->second);
        if (is_new) registry.node(id)[0] = registry.node(id)[1] = id.index();
    }
    ASSERT_EQ(registry.size(), expected.size());
    for (const auto& [values, number] : expected) {
        const StateId id(number);
        Values read(4);
        packer.unpack(registry.words(id), read.data());
        ASSERT_EQ(read, values);
        ASSERT_EQ(registry.node(id)[1], number);
    }
}

}  // namespace
}  // namespace praxis
