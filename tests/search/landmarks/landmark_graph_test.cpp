// Landmarks and their orderings against all that can happen in small tasks.
#include "search/landmarks/landmark_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "search/landmarks/landmark_draft.hpp"
#include "tests/search/evaluators/random_task.hpp"

namespace praxis {
namespace {

using test::State;

constexpr int kTasks = 20;  ///< in each run of a property; they are quick

/// Visits all states that can be reached without leaving `inside`, and all steps from them.
void explore(const FiniteDomainTask& task, const std::function<bool(const State&)>& inside,
             const std::function<void(const State&)>& visit,
             const std::function<void(const State&, const State&)>& step) {
    std::set<State> seen;
    std::vector<State> open;
    const auto discover = [&](const State& state) {
        if (!inside(state) || !seen.insert(state).second) return;
        visit(state);
        open.push_back(state);
    };
    discover(test::initial_state(task));
    while (!open.empty()) {
        const State state = open.back();
        open.pop_back();
        for (std::size_t op = 0; op < task.operator_count(); ++op) {
            if (!test::holds(state, task.preconditions[op])) continue;
            const State next = test::successor(task, state, op);
            step(state, next);
            discover(next);
        }
    }
}

/// All variables are 0 at first; each other fact has one to three operators, that need facts of smaller
/// values: rich in landmarks, disjunctive ones among them.
FiniteDomainTask random_steps() {
    FiniteDomainTask task;
    task.first_fact = {0};
    const std::int32_t variables = 3 + test::pick(3);
    for (std::int32_t v = 0; v < variables; ++v) {
        task.domain_sizes.push_back(3 + test::pick(2));
        task.axiom_layers.push_back(-1);
        task.initial_values.push_back(0);
        task.first_fact.push_back(task.first_fact.back() +
                                  static_cast<std::uint32_t>(task.domain_sizes.back()));
    }
    task.conditions.close();
    for (std::int32_t v = 0; v < variables; ++v) {
        for (std::int32_t value = 1; value < task.domain_sizes[static_cast<std::size_t>(v)]; ++value) {
            for (std::int32_t count = 1 + test::pick(3); count > 0; --count) {
                std::vector<Fact> precondition;
                for (std::int32_t other = 0; other < variables; ++other) {
                    if (test::pick(other == v ? 2 : variables) == 0) {
                        precondition.push_back({other, std::max(0, value - 1 - test::pick(2))});
                    }
                }
                task.preconditions.append(precondition);
                task.effects.append(std::vector<GroundEffect>{{{v, value}, 0}});
                task.costs.push_back(1);
            }
        }
    }
    const std::int32_t last = test::pick(variables);
    task.goal = {{last, task.domain_sizes[static_cast<std::size_t>(last)] - 1}};
    return task;
}

/// Some have names for their facts, so that disjunctive landmarks may span variables.
FiniteDomainTask random_task() {
    FiniteDomainTask task = test::pick(2) == 0 ? test::random_task() : random_steps();
    if (test::pick(3) == 0) return task;
    task.fact_names.symbols = {"p", "q"};
    for (std::size_t fact = 0; fact < task.fact_count(); ++fact) {
        task.fact_names.names.append(std::vector<std::uint32_t>{static_cast<std::uint32_t>(test::pick(2))});
        task.fact_forms.push_back(test::pick(6) == 0 ? FiniteDomainTask::FactForm::none_of_those
                                                     : FiniteDomainTask::FactForm::atom);
    }
    return task;
}

LandmarkOptions random_options() {
    LandmarkOptions options;
    if (test::pick(4) == 0) options.work = static_cast<std::uint64_t>(test::pick(300));
    options.disjunctive = test::pick(4) != 0;
    return options;
}

void check_landmarks() {
    const FiniteDomainTask task = random_task();
    const LandmarkGraph graph = make_landmark_graph(task, task.goal, task.initial_values, random_options());
    const State initial = test::initial_state(task);
    for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
        RC_ASSERT(static_cast<bool>(graph.initial[landmark]) == graph.holds(landmark, initial));
        RC_ASSERT(graph.facts[landmark].size() >= 1 && graph.facts[landmark].size() <= 4);
        explore(
            task, [&](const State& state) { return !graph.holds(landmark, state); },
            [&](const State& state) { RC_ASSERT(!test::holds(state, task.goal)); },
            [](const State&, const State&) {});
    }
    for (const Fact fact : task.goal) {
        const auto is_fact = [&](std::size_t landmark) {
            return graph.goal[landmark] && graph.facts[landmark].size() == 1 &&
                   graph.facts[landmark][0] == fact;
        };
        std::size_t count = 0;
        for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) count += is_fact(landmark);
        RC_ASSERT(count == 1u);
    }
}

RC_GTEST_PROP(LandmarkGraph, NoPlanAvoidsALandmark, ()) {
    for (int i = 0; i < kTasks; ++i) check_landmarks();
}

void check_orderings() {
    const FiniteDomainTask task = random_task();
    const LandmarkGraph graph = make_landmark_graph(task, task.goal, task.initial_values, random_options());
    for (std::size_t after = 0; after < graph.size(); ++after) {
        for (const LandmarkGraph::Neighbour before : graph.predecessors[after]) {
            RC_ASSERT(before.landmark < after);
            if (before.ordering == LandmarkOrdering::reasonable) continue;
            RC_ASSERT(!graph.initial[after] || graph.derived[after]);
            explore(
                task, [&](const State& state) { return !graph.holds(before.landmark, state); },
                [&](const State& state) { RC_ASSERT(!graph.holds(after, state)); },
                [&](const State&, const State& next) {
                    RC_ASSERT(graph.derived[after] || !graph.holds(after, next));
                });
            if (before.ordering != LandmarkOrdering::greedy_necessary) continue;
            explore(
                task, [&](const State& state) { return !graph.holds(after, state); }, [](const State&) {},
                [&](const State& state, const State& next) {
                    RC_ASSERT(!graph.holds(after, next) || graph.holds(before.landmark, state) ||
                              (graph.derived[after] && graph.holds(before.landmark, next)));
                });
        }
    }
}

RC_GTEST_PROP(LandmarkGraph, EveryPathObeysTheOrderings, ()) {
    for (int i = 0; i < kTasks; ++i) check_orderings();
}

void check_first_achievers() {
    const FiniteDomainTask task = random_task();
    const LandmarkGraph graph = make_landmark_graph(task, task.goal, task.initial_values, random_options());
    for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
        if (graph.derived[landmark]) continue;
        const auto known = graph.first_achievers[landmark];
        explore(
            task, [&](const State& state) { return !graph.holds(landmark, state); }, [](const State&) {},
            [&](const State& state, const State& next) {
                if (!graph.holds(landmark, next)) return;
                bool found = false;
                for (const std::uint32_t op : known) {
                    found = found || (test::holds(state, task.preconditions[op]) &&
                                      test::successor(task, state, op) == next);
                }
                RC_ASSERT(found);
            });
    }
}

RC_GTEST_PROP(LandmarkGraph, FirstAchieversAreAllThatCanBe, ()) {
    for (int i = 0; i < kTasks; ++i) check_first_achievers();
}

/// A truck moves along 0 - 1 - 2 - 3 (variable 0); a package (variable 1: at 0 to 3, or 4: in the truck).
FiniteDomainTask delivery() {
    FiniteDomainTask task;
    task.domain_sizes = {4, 5};
    task.axiom_layers = {-1, -1};
    task.initial_values = {0, 2};
    task.first_fact = {0, 4, 9};
    task.conditions.close();
    const auto add = [&](std::vector<Fact> precondition, Fact effect) {
        task.preconditions.append(precondition);
        task.effects.append(std::vector<GroundEffect>{{effect, 0}});
        task.costs.push_back(1);
    };
    for (std::int32_t place = 0; place < 4; ++place) {
        if (place > 0) add({{0, place}}, {0, place - 1});
        if (place < 3) add({{0, place}}, {0, place + 1});
        add({{0, place}, {1, place}}, {1, 4});
        add({{0, place}, {1, 4}}, {1, place});
    }
    task.goal = {{1, 0}};
    return task;
}

TEST(LandmarkGraph, OfADelivery) {
    const FiniteDomainTask task = delivery();
    const LandmarkGraph graph = make_landmark_graph(task, task.goal, task.initial_values);
    std::vector<Fact> found;
    for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
        ASSERT_EQ(graph.facts[landmark].size(), 1u);
        found.push_back(graph.facts[landmark][0]);
    }
    std::ranges::sort(found);
    const std::vector<Fact> expected{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 2}, {1, 4}};
    EXPECT_EQ(found, expected);
    EXPECT_TRUE(graph.complete);
    EXPECT_EQ(graph.facts[graph.size() - 1][0], (Fact{1, 0}));
}

TEST(LandmarkGraph, StaysRightWhenCutShort) {
    const FiniteDomainTask task = delivery();
    const LandmarkGraph graph =
        make_landmark_graph(task, task.goal, task.initial_values, {true, true, 0, {}});
    EXPECT_FALSE(graph.complete);
    ASSERT_EQ(graph.size(), 1u);
    EXPECT_EQ(graph.first_achievers[0].size(), 1u);
}

RC_GTEST_PROP(LandmarkGraph, CyclesAreBrokenWhereTheyAreWeak, ()) {
    LandmarkDraft draft;
    const auto size = static_cast<std::uint32_t>(2 + test::pick(6));
    draft.nodes.resize(size);
    for (std::int32_t left = test::pick(20); left > 0; --left) {
        const auto a = static_cast<std::uint32_t>(test::pick(static_cast<std::int32_t>(size)));
        const auto b = static_cast<std::uint32_t>(test::pick(static_cast<std::int32_t>(size)));
        // Strong orderings alone have no cycle.
        draft.orderings.push_back({a, b, a < b ? LandmarkOrdering::natural : LandmarkOrdering::reasonable});
    }
    draft.tidy();
    const std::vector<LandmarkDraft::Ordering> all = draft.orderings;
    const std::vector<std::uint32_t> order = break_cycles(draft);
    RC_ASSERT(order.size() == size);
    std::vector<std::size_t> place(size, size);
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (const LandmarkDraft::Ordering& o : draft.orderings) RC_ASSERT(place[o.before] < place[o.after]);
    const auto strong = [](const LandmarkDraft::Ordering& o) {
        return o.ordering == LandmarkOrdering::natural;
    };
    RC_ASSERT(std::ranges::count_if(all, strong) == std::ranges::count_if(draft.orderings, strong));
}

}  // namespace
}  // namespace praxis
