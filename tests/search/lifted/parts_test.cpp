// The parts of the lifted search by themselves: stored states, novelty, relaxed plans.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "search/lifted/novelty_table.hpp"
#include "search/lifted/relaxed_plan.hpp"
#include "search/lifted/state_store.hpp"
#include "tests/search/ground/texts.hpp"

namespace praxis::lifted {
namespace {

TEST(StateStore, GivesBackWhatWasStoredOnce) {
    ASSERT_TRUE(rc::check([](const std::vector<std::set<std::uint32_t>>& states) {
        StateStore store;
        std::map<std::set<std::uint32_t>, StateNumber> numbers;
        for (std::set<std::uint32_t> state : states) {
            state.erase(kNoAtom);
            const std::vector<AtomNumber> atoms(state.begin(), state.end());
            const auto [number, fresh] = store.insert(atoms, 7);
            RC_ASSERT(fresh == !numbers.contains(state));
            RC_ASSERT(number == numbers.try_emplace(state, number).first->second);
        }
        RC_ASSERT(store.size() == numbers.size());
        std::vector<AtomNumber> atoms;
        for (const auto& [state, number] : numbers) {
            store.read(number, atoms);
            RC_ASSERT(std::vector<AtomNumber>(state.begin(), state.end()) == atoms);
            RC_ASSERT(store.parent(number) == 7u);
        }
    }));
}

TEST(StateStore, KeepsMoreThanOneSegment) {
    StateStore store;
    std::vector<AtomNumber> atoms(20000), back;
    for (AtomNumber first = 0; first < 100; ++first) {
        for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = first + static_cast<AtomNumber>(3 * i);
        EXPECT_EQ(store.insert(atoms, kNoState).first, first);
    }
    store.read(99, back);
    EXPECT_EQ(back, atoms);
}

TEST(NoveltyTable, TellsNewAtomsFromNewPairsFromNothing) {
    NoveltyTable table(1 << 16);
    const std::vector<AtomNumber> ab{1, 2}, ac{1, 3}, bc{2, 3}, a{1}, b{2}, c{3};
    EXPECT_EQ(table.measure(0, ab, ab, true), 1);
    EXPECT_EQ(table.measure(0, ac, c, false), 1);
    EXPECT_EQ(table.measure(0, bc, b, false), 2);
    EXPECT_EQ(table.measure(0, bc, b, false), 3);
    EXPECT_EQ(table.measure(1, bc, b, true), 1) << "another partition";
}

/// A database with all that is asked of it, in the initial state.
struct Model {
    explicit Model(const LiftedTask& task)
        : database(task),
          solver(database, budget),
          axioms(database, solver),
          actions(database, solver),
          goal(database, solver),
          relaxed_plan(database, solver, axioms, actions, goal) {
        database.finish();
        axioms.finish();
        goal.finish();
    }
    void load(std::initializer_list<std::pair<PredicateNumber, std::vector<ObjectNumber>>> atoms) {
        std::vector<AtomNumber> numbers;
        for (const auto& [predicate, arguments] : atoms)
            numbers.push_back(database.intern(predicate, arguments.data()));
        std::ranges::sort(numbers);
        database.load(numbers);
        axioms.derive();
    }
    std::uint64_t bits(PredicateNumber predicate, std::vector<ObjectNumber> arguments) {
        const AtomNumber atom = database.intern(predicate, arguments.data());
        return relaxed_plan.bits({&atom, 1});
    }

    Budget budget;
    Database database;
    QuerySolver solver;
    Axioms axioms;
    Actions actions;
    Goal goal;
    RelaxedPlan relaxed_plan;
};

TEST(RelaxedPlan, HasTheAtomsOnTheWay) {
    const Task task = test::task_of(
        "(:predicates (at ?x - thing) (next ?x ?y - thing))"
        "(:action go :parameters (?x ?y - thing) :precondition (and (at ?x) (next ?x ?y) (not (at ?y)))"
        " :effect (and (at ?y) (not (at ?x))))",
        "(at a) (next a b) (next b c) (next b d)", "(at c)", "", "a b c d - thing");
    Model model(*task);
    model.load({{0, {0}}});
    EXPECT_EQ(model.relaxed_plan.explore(1000), 1u + 3u);
    EXPECT_NE(model.bits(0, {1}), 0u);
    EXPECT_NE(model.bits(0, {2}), 0u);
    EXPECT_NE(model.bits(0, {1}), model.bits(0, {2}));
    EXPECT_EQ(model.bits(0, {0}), 0u) << "holds already";
    EXPECT_EQ(model.bits(0, {3}), 0u) << "off the way";

    model.load({{0, {0}}});
    EXPECT_EQ(model.relaxed_plan.explore(2), 2u);
    EXPECT_EQ(model.bits(0, {2}), 0u) << "given up";
}

}  // namespace
}  // namespace praxis::lifted
