// Ground tasks survive being written and read.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <sstream>
#include <vector>

#include "search/ground/ground.hpp"
#include "search/task/sas.hpp"
#include "tests/search/ground/moving_task.hpp"

namespace praxis {
namespace {

std::vector<Fact> list(std::span<const Fact> facts) {
    return {facts.begin(), facts.end()};
}

void check_same(const FiniteDomainTask& a, const FiniteDomainTask& b) {
    RC_ASSERT(a.domain_sizes == b.domain_sizes);
    RC_ASSERT(a.axiom_layers == b.axiom_layers);
    RC_ASSERT(a.initial_values == b.initial_values);
    RC_ASSERT(a.goal == b.goal);
    RC_ASSERT(a.costs == b.costs);
    RC_ASSERT(a.unit_cost == b.unit_cost);
    for (std::size_t v = 0; v < a.variable_count(); ++v)
        for (std::int32_t value = 0; value < a.domain_sizes[v]; ++value) {
            const Fact fact{static_cast<std::int32_t>(v), value};
            RC_ASSERT(a.fact_name(fact) == b.fact_name(fact));
        }
    for (std::size_t o = 0; o < a.operator_count(); ++o) {
        RC_ASSERT(a.operator_name(OperatorId(o)) == b.operator_name(OperatorId(o)));
        RC_ASSERT(list(a.preconditions[o]) == list(b.preconditions[o]));
        RC_ASSERT(a.effects[o].size() == b.effects[o].size());
        for (std::size_t e = 0; e < a.effects[o].size(); ++e) {
            RC_ASSERT(a.effects[o][e].fact == b.effects[o][e].fact);
            RC_ASSERT(list(a.conditions[a.effects[o][e].condition]) ==
                      list(b.conditions[b.effects[o][e].condition]));
        }
    }
    RC_ASSERT(a.axioms.size() == b.axioms.size());
    for (std::size_t i = 0; i < a.axioms.size(); ++i) {
        RC_ASSERT(a.axioms[i].head == b.axioms[i].head);
        RC_ASSERT(list(a.axiom_bodies[i]) == list(b.axiom_bodies[i]));
    }
    RC_ASSERT(a.mutex_groups.size() == b.mutex_groups.size());
    for (std::size_t g = 0; g < a.mutex_groups.size(); ++g)
        RC_ASSERT(list(a.mutex_groups[g]) == list(b.mutex_groups[g]));
}

TEST(GroundSas, IsReadAsItWasWritten) {
    std::size_t tried = 0, tasks = 0, axioms = 0, conditional = 0;
    ASSERT_TRUE(rc::check([&] {
        const auto first = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        for (std::uint32_t seed = first; seed != first + 5; ++seed) {
            ++tried;
            GroundOptions options;
            options.prune_irrelevant = seed % 2 == 0;
            const auto task = ground(*test::moving_task(seed).task, options).task;
            // The format has no such tasks: another one is written.
            if (task->goal.empty() || task->proved_unsolvable) continue;
            ++tasks;
            axioms += task->has_axioms();
            conditional += task->has_conditional_effects();
            std::ostringstream text;
            write_sas(*task, text);
            check_same(*task, read_sas({"task.sas", text.str()}));
        }
    }));
    EXPECT_GT(tasks, tried / 5);
    EXPECT_GT(axioms, tried / 100);
    EXPECT_GT(conditional, tried / 100);
}

}  // namespace
}  // namespace praxis
