// Successor generator, axioms and effects against their literal meaning on random tasks.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "search/state/axiom_evaluator.hpp"
#include "search/state/successor_generator.hpp"
#include "search/state/transitions.hpp"
#include "tests/search/state/random_task.hpp"

namespace praxis {
namespace {

using test::add_axiom;
using test::add_operator;
using test::add_variable;
using test::at;
using test::random_task;
using test::Values;

Values random_values(const FiniteDomainTask& task, std::mt19937_64& random) {
    Values values;
    for (std::int32_t size : task.domain_sizes) {
        values.push_back(static_cast<std::int32_t>(random() % static_cast<unsigned>(size)));
    }
    return values;
}

TEST(SuccessorGenerator, FindsTheApplicableOperators) {
    EXPECT_TRUE(rc::check([] {
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const FiniteDomainTask task = random_task(seed, {.variables = *rc::gen::inRange(1, 8),
                                                         .largest_domain = *rc::gen::element(2, 4, 40),
                                                         .derived = *rc::gen::inRange(0, 3),
                                                         .operators = *rc::gen::element(0, 1, 10, 200)});
        const SuccessorGenerator generator(task);
        std::mt19937_64 random(seed);
        std::vector<OperatorId> found;
        for (int i = 0; i < 20; ++i) {
            const Values values = random_values(task, random);
            generator.applicable(values.data(), found);
            std::sort(found.begin(), found.end());
            RC_ASSERT(found == test::applicable(task, values));
        }
    }));
}

TEST(SuccessorGenerator, StopsWhenTheBudgetIsSpent) {
    FiniteDomainTask task;
    for (int i = 0; i < 20; ++i) add_variable(task, 50, 0);
    std::mt19937_64 random(1);
    for (int i = 0; i < 300000; ++i) {
        const auto first = static_cast<std::int32_t>(random() % 10),
                   second = 10 + static_cast<std::int32_t>(random() % 10);
        const auto value = static_cast<std::int32_t>(random() % 50);
        add_operator(task, {{first, value}, {second, 49 - value}}, {{{first, 0}, {}}});
    }
    std::stop_source source;
    source.request_stop();
    Budget budget;
    budget.stop_with(source.get_token());
    const SuccessorGenerator generator(task, budget);
    std::vector<OperatorId> found;
    Values values(20, 0);
    std::fill(values.begin() + 10, values.end(), 49);
    generator.applicable(values.data(), found);
    EXPECT_LT(found.size(), test::applicable(task, values).size());
}

TEST(AxiomEvaluator, ReachesTheStratifiedFixpoint) {
    EXPECT_TRUE(rc::check([] {
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const FiniteDomainTask task = random_task(
            seed,
            {.variables = *rc::gen::inRange(0, 6), .derived = *rc::gen::inRange(1, 12), .operators = 0});
        const AxiomEvaluator evaluator(task);
        AxiomEvaluator::Scratch scratch;
        std::mt19937_64 random(seed);
        for (int i = 0; i < 20; ++i) {
            Values values = random_values(task, random);
            Values expected = values;
            test::derive(task, expected);
            evaluator.complete(values.data(), scratch);
            RC_ASSERT(values == expected);
        }
    }));
}

TEST(AxiomEvaluator, FollowsChainsThroughLayers) {
    // reached(0); reached(i+1) :- reached(i), open(i); blocked :- not reached(3).
    FiniteDomainTask task;
    for (std::int32_t i = 0; i < 3; ++i) add_variable(task, 2, 0);
    for (std::int32_t i = 0; i < 4; ++i) add_variable(task, 2, 0, 0);
    add_variable(task, 2, 0, 1);
    add_axiom(task, {3, 1}, {});
    for (std::int32_t i = 0; i < 3; ++i) add_axiom(task, {4 + i, 1}, {{i, 1}, {3 + i, 1}});
    add_axiom(task, {7, 1}, {{6, 0}});
    const AxiomEvaluator evaluator(task);
    AxiomEvaluator::Scratch scratch;
    Values values{1, 1, 0, 9, 9, 9, 9, 9};
    evaluator.complete(values.data(), scratch);
    EXPECT_EQ(values, (Values{1, 1, 0, 1, 1, 1, 0, 1}));
    values[2] = 1;
    evaluator.complete(values.data(), scratch);
    EXPECT_EQ(values, (Values{1, 1, 1, 1, 1, 1, 1, 0}));
}

TEST(Transitions, ReadTheStateBefore) {
    // Swaps two variables; the later effect on a variable wins.
    FiniteDomainTask task;
    for (int i = 0; i < 3; ++i) add_variable(task, 2, 0);
    const OperatorId swap = add_operator(
        task, {}, {{{0, 0}, {{1, 0}}}, {{0, 1}, {{1, 1}}}, {{1, 0}, {{0, 0}}}, {{1, 1}, {{0, 1}}}});
    const OperatorId last_wins = add_operator(task, {}, {{{2, 0}, {}}, {{2, 1}, {}}});
    const StatePacker packer(task);
    const Transitions transitions(task, packer);
    EXPECT_TRUE(transitions.conditional(swap));
    EXPECT_FALSE(transitions.conditional(last_wins));
    const Values before{1, 0, 0};
    std::vector<std::uint32_t> words(packer.word_count());
    packer.pack(before.data(), words.data());
    transitions.apply(swap, before.data(), words.data());
    transitions.apply(last_wins, nullptr, words.data());
    Values after(3);
    packer.unpack(words.data(), after.data());
    EXPECT_EQ(after, (Values{0, 1, 1}));
}

TEST(Transitions, AgreeWithTheNaiveSuccessor) {
    EXPECT_TRUE(rc::check([] {
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        const FiniteDomainTask task = random_task(
            seed, {.variables = 6, .derived = *rc::gen::inRange(0, 3), .conditional_effects = true});
        const StatePacker packer(task);
        const Transitions transitions(task, packer);
        std::mt19937_64 random(seed);
        Values before = random_values(task, random);
        test::derive(task, before);
        std::vector<std::uint32_t> words(packer.word_count());
        for (std::size_t i = 0; i < task.operator_count(); ++i) {
            const OperatorId op(i);
            const Values expected = test::successor(task, before, op);
            packer.pack(before.data(), words.data());
            transitions.apply(op, before.data(), words.data());
            Values by_words = before, by_values = before;
            packer.unpack(words.data(), by_words.data());
            transitions.apply(op, before.data(), by_values.data());
            RC_ASSERT(by_words == by_values);
            test::derive(task, by_words);
            RC_ASSERT(by_words == expected);
        }
    }));
}

}  // namespace
}  // namespace praxis
