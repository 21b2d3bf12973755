// Operations on conditions against their truth tables.
#include "belief/ground/dnf.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "search/engines/random.hpp"

namespace praxis::belief {
namespace {

const std::vector<std::int32_t> kSizes{2, 3, 2, 2};

Dnf any_dnf(Random& random) {
    Dnf result;
    for (std::size_t terms = random.below(4); terms > 0; --terms) {
        std::vector<Fact> facts;
        for (std::size_t i = random.below(4); i > 0; --i) {
            const auto variable = static_cast<std::int32_t>(random.below(kSizes.size()));
            const auto size = static_cast<std::size_t>(kSizes[static_cast<std::size_t>(variable)]);
            facts.push_back({variable, static_cast<std::int32_t>(random.below(size))});
        }
        result = result | Dnf::of(facts);
    }
    return result;
}

template <class Visit>
void for_each_state(const Visit& visit) {
    std::vector<std::int32_t> state(kSizes.size(), 0);
    const auto choose = [&](const auto& self, std::size_t next) -> void {
        if (next == state.size()) return visit(state);
        for (state[next] = 0; state[next] < kSizes[next]; ++state[next]) self(self, next + 1);
    };
    choose(choose, 0);
}

RC_GTEST_PROP(Dnf, OperationsAgreeWithTruthTables, ()) {
    Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()));
    const Dnf a = any_dnf(random), b = any_dnf(random);
    const Dnf either = a | b, both = a & b, neither = negation(either, kSizes);
    for_each_state([&](const std::vector<std::int32_t>& state) {
        const bool left = a.holds(state.data()), right = b.holds(state.data());
        RC_ASSERT(either.holds(state.data()) == (left || right));
        RC_ASSERT(both.holds(state.data()) == (left && right));
        RC_ASSERT(neither.holds(state.data()) == !(left || right));
    });
}

RC_GTEST_PROP(Dnf, WhatIsLeftAgreesWhereTheValuesAreAsKnown, ()) {
    Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()));
    const Dnf a = any_dnf(random);
    const std::vector<std::int32_t> known{random.below(2) == 0 ? -1 : 1, random.below(2) == 0 ? -1 : 2, -1,
                                          -1};
    const Dnf left = given(a, known);
    for_each_state([&](const std::vector<std::int32_t>& state) {
        for (std::size_t v = 0; v < state.size(); ++v)
            if (known[v] >= 0 && state[v] != known[v]) return;
        RC_ASSERT(left.holds(state.data()) == a.holds(state.data()));
    });
}

TEST(Dnf, TermsThatContainOthersGo) {
    const Fact x{0, 0}, y{1, 2};
    EXPECT_EQ(Dnf::of(x) | (Dnf::of(x) & Dnf::of(y)), Dnf::of(x));
    EXPECT_EQ((Dnf::of(x) & Dnf::of(y)) | Dnf::of(x), Dnf::of(x));
    EXPECT_TRUE((Dnf::of(x) | Dnf::always()).is_always());
    EXPECT_TRUE((Dnf::of(x) & Dnf::of({0, 1})).is_never());
}

TEST(Dnf, TooManyTermsAreRefused) {
    const std::vector<std::int32_t> sizes(64, 2);
    Dnf pairs;
    for (std::int32_t i = 0; i < 32; ++i) pairs = pairs | (Dnf::of({2 * i, 0}) & Dnf::of({2 * i + 1, 0}));
    EXPECT_THROW(negation(pairs, sizes), DnfTooLarge);
}

}  // namespace
}  // namespace praxis::belief
