// Nogoods, against a search that remembers which events have happened. (Here, because it takes a search to
// see what a restricted task allows.)
#include "search/task/restrict.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <map>
#include <stdexcept>

#include "search/engines/random.hpp"
#include "search/engines/search.hpp"

namespace praxis {
namespace {

/// Variables without axioms; some effects are conditional.
FiniteDomainTask random_task(Random& random) {
    FiniteDomainTask task;
    const std::size_t variables = 2 + random.below(3);
    std::uint32_t facts = 0;
    for (std::size_t v = 0; v < variables; ++v) {
        task.domain_sizes.push_back(2 + static_cast<std::int32_t>(random.below(3)));
        task.axiom_layers.push_back(-1);
        task.initial_values.push_back(0);
        task.first_fact.push_back(facts);
        facts += static_cast<std::uint32_t>(task.domain_sizes.back());
    }
    task.first_fact.push_back(facts);
    task.fact_names.symbols = {"fact"};
    for (std::uint32_t f = 0; f < facts; ++f) task.fact_names.names.append(std::vector<std::uint32_t>{0});
    task.fact_forms.assign(facts, FiniteDomainTask::FactForm::atom);
    const auto some_facts = [&](std::size_t chance) {
        std::vector<Fact> result;
        for (std::size_t v = 0; v < variables; ++v)
            if (random.below(chance) == 0)
                result.push_back({static_cast<std::int32_t>(v),
                                  static_cast<std::int32_t>(
                                      random.below(static_cast<std::size_t>(task.domain_sizes[v])))});
        return result;
    };
    task.conditions.close();
    task.operator_names.symbols = {"operator"};
    const std::size_t operators = 3 + random.below(5);
    for (std::size_t op = 0; op < operators; ++op) {
        task.preconditions.append(some_facts(3));
        std::vector<Fact> effects = some_facts(2);
        if (effects.empty()) effects.push_back({0, 1});
        for (const Fact& effect : effects) {
            std::uint32_t condition = 0;
            if (random.below(3) == 0) {
                const std::vector<Fact> when = some_facts(3);
                if (!when.empty()) {
                    condition = static_cast<std::uint32_t>(task.conditions.size());
                    task.conditions.append(when);
                }
            }
            task.effects.add({effect, condition});
        }
        task.effects.close();
        task.costs.push_back(1);
        task.operator_names.names.append(std::vector<std::uint32_t>{0});
    }
    task.goal = some_facts(2);
    if (task.goal.empty()) task.goal = {{0, 1}};
    return task;
}

std::vector<Nogood> random_nogoods(const FiniteDomainTask& task, Random& random) {
    std::vector<Nogood> result(1 + random.below(4));
    for (Nogood& nogood : result) {
        const std::size_t events = random.below(3) == 0 ? 2 : 1;
        while (nogood.events.size() < events) {
            Event event;
            if (random.below(6) != 0) event.op = OperatorId(random.below(task.operator_count()));
            for (std::size_t v = 0; v < task.variable_count(); ++v)
                if (random.below(2) == 0)
                    event.facts.push_back(
                        {static_cast<std::int32_t>(v), static_cast<std::int32_t>(random.below(
                                                           static_cast<std::size_t>(task.domain_sizes[v])))});
            // What one application does at once is not for marks to see.
            const bool same = !nogood.events.empty() && nogood.events.front().op == event.op;
            if (!same) nogood.events.push_back(std::move(event));
        }
    }
    return result;
}

/// The length of a shortest plan that has no nogood among its events; -1: there is none.
int shortest(const FiniteDomainTask& task, const std::vector<Nogood>& nogoods) {
    using Node =
        std::pair<std::vector<std::int32_t>, std::vector<bool>>;  // values, events that have happened
    std::vector<const Event*> events;
    for (const Nogood& nogood : nogoods)
        for (const Event& event : nogood.events) events.push_back(&event);
    const auto broken = [&](const std::vector<bool>& happened) {
        std::size_t i = 0;
        for (const Nogood& nogood : nogoods) {
            bool all = true;
            for (std::size_t k = 0; k < nogood.events.size(); ++k) all = happened[i++] && all;
            if (all) return true;
        }
        return false;
    };
    const auto note = [&](const std::vector<std::int32_t>& values, OperatorId op,
                          std::vector<bool>& happened) {
        for (std::size_t i = 0; i < events.size(); ++i)
            if (events[i]->op == op && all_hold(events[i]->facts, values.data())) happened[i] = true;
    };
    const Node start{task.initial_values, std::vector<bool>(events.size(), false)};
    std::map<Node, int> length{{start, 0}};
    std::deque<Node> open{start};
    while (!open.empty()) {
        const Node node = open.front();
        open.pop_front();
        const int steps = length[node];
        if (all_hold(task.goal, node.first.data())) {
            std::vector<bool> happened = node.second;
            note(node.first, OperatorId(), happened);
            if (!broken(happened)) return steps;
        }
        for (std::size_t op = 0; op < task.operator_count(); ++op) {
            if (!all_hold(task.preconditions[op], node.first.data())) continue;
            Node next = node;
            note(node.first, OperatorId(op), next.second);
            if (broken(next.second)) continue;
            for (const GroundEffect& effect : task.effects[op])
                if (all_hold(task.conditions[effect.condition], node.first.data()))
                    next.first[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
            if (length.try_emplace(next, steps + 1).second) open.push_back(next);
        }
    }
    return -1;
}

int planned(std::shared_ptr<const FiniteDomainTask> task, const std::string& expression) {
    const PreparedTask prepared(std::move(task));
    const Outcome outcome = search(prepared, task_query(prepared.task()), configuration(expression));
    return outcome.plan ? static_cast<int>(outcome.plan->size()) : -1;
}

RC_GTEST_PROP(Restrict, AllowsExactlyThePlansWithoutNogoods, ()) {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const FiniteDomainTask task = random_task(random);
    const std::vector<Nogood> nogoods = random_nogoods(task, random);
    const auto restricted = restrict(task, nogoods);
    RC_ASSERT(restricted->operator_count() == task.operator_count());
    RC_ASSERT(planned(restricted, "astar(blind())") == shortest(task, nogoods));
    RC_ASSERT((planned(restricted, "lazy_greedy([ff()],preferred=[ff()])") >= 0) ==
              (shortest(task, nogoods) >= 0));
}

TEST(Restrict, OfNothingIsTheTaskItself) {
    Random random(1);
    const FiniteDomainTask task = random_task(random);
    const auto same = restrict(task, {});
    EXPECT_EQ(same->variable_count(), task.variable_count());
    EXPECT_EQ(same->preconditions.items(), task.preconditions.items());
}

TEST(Restrict, RefusesWhatTheTaskDoesNotHave) {
    Random random(1);
    const FiniteDomainTask task = random_task(random);
    const auto refused = [&](const Nogood& nogood) {
        EXPECT_THROW(restrict(task, {&nogood, 1}), std::invalid_argument);
    };
    refused({});
    refused({{{OperatorId(task.operator_count()), {}}}});
    refused({{{OperatorId(0), {{0, 99}}}}});
    refused({{{OperatorId(0), {{99, 0}}}}});
    refused({{{OperatorId(0), {{0, 0}, {0, 1}}}}});
}

}  // namespace
}  // namespace praxis
