// hmax, hadd, FF and LM-cut against definitions and brute force on random tasks.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "search/evaluators/blind.hpp"
#include "search/evaluators/ff.hpp"
#include "search/evaluators/hadd.hpp"
#include "search/evaluators/hmax.hpp"
#include "search/evaluators/lmcut.hpp"
#include "search/evaluators/operator_costs.hpp"
#include "tests/search/evaluators/naive_relaxation.hpp"

namespace praxis::test {
namespace {

constexpr int kTasks = 10;  ///< for each case of a property

/// A random task with everything that the properties look at.
struct Sample {
    FiniteDomainTask task = random_task();
    CostType cost_type = *rc::gen::element(CostType::normal, CostType::one, CostType::plus_one);
    std::vector<std::int32_t> costs = operator_costs(task, cost_type);
    std::map<State, Estimate> perfect = perfect_estimates(task, costs);
};

RC_GTEST_PROP(Relaxation, HmaxAndHaddAreWhatTheirDefinitionSays, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const Sample sample;
        HmaxEvaluator hmax(sample.task, sample.task.goal, sample.cost_type);
        AddEvaluator hadd(sample.task, sample.task.goal, sample.cost_type);
        NaiveRelaxation naive_max(sample.task, sample.costs, false);
        NaiveRelaxation naive_sum(sample.task, sample.costs, true);
        for (const auto& [state, perfect] : sample.perfect) {
            RC_ASSERT(hmax.evaluate(state) == naive_max.goal_cost(state));
            RC_ASSERT(hadd.evaluate(state) == naive_sum.goal_cost(state));
        }
    }
}

RC_GTEST_PROP(Relaxation, AdmissibleEstimatesNeverExceedPlans, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const Sample sample;
        BlindEvaluator blind(sample.task, sample.task.goal, sample.cost_type);
        HmaxEvaluator hmax(sample.task, sample.task.goal, sample.cost_type);
        LMCutEvaluator lmcut(sample.task, sample.task.goal, sample.cost_type);
        for (const auto& [state, perfect] : sample.perfect) {
            const Estimate maximum = hmax.evaluate(state);
            const Estimate cuts = lmcut.evaluate(state);
            RC_ASSERT(maximum <= cuts);
            RC_ASSERT(cuts <= perfect);
            RC_ASSERT(blind.evaluate(state) <= perfect);
            RC_ASSERT((cuts == kDeadEnd) == (maximum == kDeadEnd));
        }
    }
}

RC_GTEST_PROP(Relaxation, HmaxIsConsistent, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const Sample sample;
        HmaxEvaluator hmax(sample.task, sample.task.goal, sample.cost_type);
        for (const auto& [state, perfect] : sample.perfect) {
            const std::int64_t here = hmax.evaluate(state);
            for (std::size_t op = 0; op < sample.task.operator_count(); ++op) {
                if (!holds(state, sample.task.preconditions[op])) continue;
                const std::int64_t there = hmax.evaluate(successor(sample.task, state, op));
                RC_ASSERT(here <= there + sample.costs[op]);
            }
        }
    }
}

RC_GTEST_PROP(Relaxation, FFExtractsARelaxedPlan, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const Sample sample;
        FFEvaluator ff(sample.task, sample.task.goal, sample.cost_type);
        ff.request_preferred();
        AddEvaluator hadd(sample.task, sample.task.goal, sample.cost_type);
        NaiveRelaxation relaxation(sample.task, sample.costs, false);
        for (const auto& [state, perfect] : sample.perfect) {
            const Estimate estimate = ff.evaluate(state);
            const Estimate sum = hadd.evaluate(state);
            RC_ASSERT((estimate == kDeadEnd) == (sum == kDeadEnd));
            RC_ASSERT(estimate <= sum);
            if (estimate == kDeadEnd) {
                RC_ASSERT(perfect == kDeadEnd);
                RC_ASSERT(ff.relaxed_plan().empty() && ff.preferred().empty());
                continue;
            }
            std::set<std::size_t> plan;
            Estimate cost = 0;
            for (const OperatorId op : ff.relaxed_plan()) {
                RC_ASSERT(plan.insert(op.index()).second);
                cost += sample.costs[op.index()];
            }
            RC_ASSERT(cost == estimate);
            std::set<OperatorId> preferred;
            for (const OperatorId op : ff.preferred()) {
                RC_ASSERT(preferred.insert(op).second);
                RC_ASSERT(plan.contains(op.index()));
                RC_ASSERT(holds(state, sample.task.preconditions[op.index()]));
            }
            RC_ASSERT(plan.empty() || !preferred.empty() || sample.task.has_axioms());
            relaxation.restrict_to(plan);
            RC_ASSERT(relaxation.goal_cost(state) != kDeadEnd);
        }
    }
}

RC_GTEST_PROP(Relaxation, EstimatesDependOnTheStateAlone, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const Sample sample;
        FFEvaluator ff(sample.task, sample.task.goal, sample.cost_type);
        LMCutEvaluator lmcut(sample.task, sample.task.goal, sample.cost_type);
        std::map<State, std::pair<Estimate, Estimate>> first;
        for (const auto& [state, perfect] : sample.perfect)
            first[state] = {ff.evaluate(state), lmcut.evaluate(state)};
        for (auto place = first.rbegin(); place != first.rend(); ++place) {
            RC_ASSERT(ff.evaluate(place->first) == place->second.first);
            RC_ASSERT(lmcut.evaluate(place->first) == place->second.second);
        }
    }
}

}  // namespace
}  // namespace praxis::test
