// First states: what can be deduced of them, all of them, and random ones, against all assignments.
#include "belief/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "belief/initial_knowledge.hpp"
#include "belief/simulated_world.hpp"
#include "parser/diagnostic.hpp"
#include "tests/belief/naive_belief.hpp"
#include "tests/belief/random_contingent.hpp"

namespace praxis::belief::test {
namespace {

constexpr std::size_t kVariables = 6;

Random any_random() {
    return Random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()));
}

Fact random_fact(Random& random) {
    return {static_cast<std::int32_t>(random.below(kVariables)), static_cast<std::int32_t>(random.below(2))};
}

/// Only what speaks of the first state.
BeliefTask random_description(Random& random) {
    BeliefTask task;
    task.initial_values.assign(kVariables, BeliefTask::kUnknown);
    const auto add = [&](PackedLists<Fact>& lists, std::size_t size) {
        std::set<std::int32_t> variables;
        std::vector<Fact> facts;
        while (facts.size() < size) {
            const Fact fact = random_fact(random);
            if (variables.insert(fact.variable).second) facts.push_back(fact);
        }
        lists.append(facts);
    };
    for (std::size_t i = random.below(9); i > 0; --i) add(task.clauses, 1 + random.below(4));
    for (std::size_t i = random.below(3); i > 0; --i) add(task.groups, 2 + random.below(3));
    return task;
}

std::vector<WorldState> models(const BeliefTask& task) {
    std::vector<WorldState> result;
    for (std::size_t choice = 0; choice < std::size_t{1} << kVariables; ++choice) {
        WorldState state;
        for (std::size_t v = 0; v < kVariables; ++v)
            state.push_back(static_cast<std::int32_t>(choice >> (kVariables - 1 - v) & 1));
        const auto holding = [&](std::span<const Fact> facts) {
            return std::count_if(facts.begin(), facts.end(), [&](const Fact& fact) {
                return state[static_cast<std::size_t>(fact.variable)] == fact.value;
            });
        };
        bool allowed = true;
        for (std::size_t c = 0; c < task.clauses.size(); ++c)
            allowed = allowed && holding(task.clauses[c]) > 0;
        for (std::size_t g = 0; g < task.groups.size(); ++g) allowed = allowed && holding(task.groups[g]) < 2;
        if (allowed) result.push_back(std::move(state));
    }
    return result;
}

bool holds_in(const WorldState& state, Fact fact) {
    return state[static_cast<std::size_t>(fact.variable)] == fact.value;
}

RC_GTEST_PROP(InitialKnowledgeProperties, OnlyConsequencesAreLearnt, ()) {
    Random random = any_random();
    const BeliefTask task = random_description(random);
    std::vector<WorldState> left = models(task);
    InitialKnowledge knowledge(task);
    if (!knowledge.consistent()) RC_ASSERT(left.empty());
    if (!knowledge.consistent()) return;
    const auto values = [&] {
        WorldState result;
        for (std::size_t v = 0; v < kVariables; ++v)
            result.push_back(knowledge.value(static_cast<std::int32_t>(v)));
        return result;
    };
    for (std::size_t step = 0; step < 5; ++step) {
        const WorldState before = values();
        for (std::size_t v = 0; v < kVariables; ++v)
            for (const WorldState& state : left)
                RC_ASSERT(before[v] == BeliefTask::kUnknown || before[v] == state[v]);
        const Fact fact = random_fact(random);
        std::vector<std::int32_t> news{-7};
        const bool learnt = knowledge.learn(fact, news, random.below(2) == 0);
        const WorldState after = values();
        RC_ASSERT(news.front() == -7);
        std::set<std::int32_t> fresh(news.begin() + 1, news.end());
        RC_ASSERT(fresh.size() + 1 == news.size());
        if (!learnt) {
            RC_ASSERT(after == before);
            RC_ASSERT(fresh.empty());
            for (const WorldState& state : left) RC_ASSERT(!holds_in(state, fact));
            continue;
        }
        std::erase_if(left, [&](const WorldState& state) { return !holds_in(state, fact); });
        RC_ASSERT(holds_in(after, fact));
        for (std::size_t v = 0; v < kVariables; ++v)
            RC_ASSERT((after[v] != before[v]) == fresh.contains(static_cast<std::int32_t>(v)));
    }
}

RC_GTEST_PROP(InitialKnowledgeProperties, WithAllValuesKnownTheDescriptionHolds, ()) {
    Random random = any_random();
    const BeliefTask task = random_description(random);
    InitialKnowledge knowledge(task);
    if (!knowledge.consistent()) return;
    std::vector<std::int32_t> news;
    WorldState state;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(kVariables); ++v) {
        if (knowledge.value(v) == BeliefTask::kUnknown && !knowledge.learn({v, 1}, news, true) &&
            !knowledge.learn({v, 0}, news, true))
            return;
        state.push_back(knowledge.value(v));
    }
    const std::vector<WorldState> all = models(task);
    RC_ASSERT(std::find(all.begin(), all.end(), state) != all.end());
}

RC_GTEST_PROP(WorldsProperties, AllFirstStatesAreEnumeratedOnce, ()) {
    Random random = any_random();
    const BeliefTask task = random_description(random);
    const std::vector<WorldState> all = models(task);
    const auto found = enumerate_worlds(task, all.size());
    RC_ASSERT(found.has_value());
    RC_ASSERT(*found == all);  // in the order of the values
    if (!all.empty()) RC_ASSERT(!enumerate_worlds(task, all.size() - 1).has_value());
}

RC_GTEST_PROP(WorldsProperties, SampledStatesAreFirstStates, ()) {
    Random random = any_random();
    const BeliefTask task = random_description(random);
    const std::vector<WorldState> all = models(task);
    for (int i = 0; i < 5; ++i) {
        const auto world = sample_world(task, random);
        RC_ASSERT(world.has_value() == !all.empty());
        if (world) RC_ASSERT(std::find(all.begin(), all.end(), *world) != all.end());
    }
}

RC_GTEST_PROP(WorldsProperties, FirstStatesAreThoseOfTheText, ()) {
    const Texts texts = random_contingent(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()));
    RC_LOG() << texts.domain << "\n" << texts.problem << "\n";
    std::shared_ptr<const BeliefTask> task;
    try {
        task = ground(texts);
    } catch (const InputError& error) {
        const std::string what = error.what();
        RC_ASSERT(what.find("no first state satisfies this") != std::string::npos ||
                  what.find("unsupported: a negative literal about an atom that is one of several values") !=
                      std::string::npos);
        return;
    }
    if (task->physical->proved_unsolvable) return;
    const NaiveBelief naive(*task);
    const std::vector<NaiveBelief::State> states = naive.first_states();
    const std::set<NaiveBelief::State> expected(states.begin(), states.end());
    std::set<NaiveBelief::State> found;
    const auto worlds = enumerate_worlds(*task, 1000);
    RC_ASSERT(worlds.has_value());
    for (const WorldState& world : *worlds)
        RC_ASSERT(found.insert(naive.of(SimulatedWorld(task, world).state())).second);
    RC_ASSERT(found == expected);
    for (std::size_t atom : naive.uncertain()) RC_ASSERT(naive.represented(atom));
}

TEST(Worlds, EachOfExactlyOneIsAboutEquallyLikely) {
    const auto task =
        ground(propositional("(p) (q) (r) (g)", "(:action win :parameters () :precondition (p) :effect (g))",
                             "(oneof (p) (q) (r))", "(g)"));
    Random random(1);
    std::vector<int> counts(3);
    for (int i = 0; i < 3000; ++i) {
        const auto world = sample_world(*task, random);
        ASSERT_TRUE(world);
        for (std::size_t a = 0; a < 3; ++a) {
            const Fact fact = fact_of(*task, std::vector<std::string>{"(p)", "(q)", "(r)"}[a]);
            counts[a] += holds_in(*world, fact);
        }
    }
    for (int count : counts) EXPECT_NEAR(count, 1000, 120);
}

TEST(Worlds, HiddenWorldsAreTheUncertainAtomsThatHold) {
    Texts texts = propositional(
        "(p) (q) (r) (g)", "(:action win :parameters () :precondition (and (p) (r)) :effect (g))",
        "(r) (unknown (p)) (unknown (q))", "(g)", "(:hidden (p)) (:hidden (not (p)) (q))");
    texts.worlds = {"(define (problem more) (:hidden (q) (p)))", "(define (problem none) (:hidden))"};
    const auto task = ground(texts);
    ASSERT_EQ(task->worlds.size(), 4u);
    const auto text = [&](std::size_t i) {
        const WorldState world = hidden_world(*task, i);
        std::string result;
        for (const char* atom : {"(p)", "(q)", "(r)"})
            if (const Fact fact = fact_of(*task, atom); fact.variable < 0 || holds_in(world, fact))
                result += atom;
        return result;
    };
    EXPECT_EQ(text(0), "(p)(r)");
    EXPECT_EQ(text(1), "(q)(r)");
    EXPECT_EQ(text(2), "(p)(q)(r)");
    EXPECT_EQ(text(3), "(r)");
}

}  // namespace
}  // namespace praxis::belief::test
