#include "belief/offline/plan_blocks.hpp"

#include "belief/environment.hpp"

namespace praxis::belief {
namespace {

/// A value of the variable that names an atom, not the lack of one.
std::int32_t named_value(const FiniteDomainTask& task, std::int32_t variable) {
    const std::int32_t size = task.domain_sizes[static_cast<std::size_t>(variable)];
    for (std::int32_t value = 0; value < size; ++value)
        if (task.is_atom({variable, value})) return value;
    return 0;
}

/// By node: whether it begins a block.
std::vector<bool> block_starts(const ConditionalPlan& plan) {
    std::vector<std::uint32_t> entered(plan.size(), 0);
    std::vector<bool> starts(plan.size(), false);
    starts[0] = true;
    for (std::uint32_t node = 0; node < plan.size(); ++node) {
        const auto edges = plan.edges(node);
        for (const ConditionalPlan::Edge& edge : edges) {
            ++entered[edge.target];
            if (edges.size() > 1) starts[edge.target] = true;
        }
    }
    for (std::uint32_t node = 0; node < plan.size(); ++node) starts[node] = starts[node] || entered[node] > 1;
    return starts;
}

}  // namespace

std::string report_atom(const BeliefTask& task, std::int32_t variable) {
    const FiniteDomainTask& physical = *task.physical;
    return "(" +
           physical.fact_names.words(physical.fact_number({variable, named_value(physical, variable)})) + ")";
}

bool report_holds(const BeliefTask& task, const ConditionalPlan::Report& report) {
    return report.value == named_value(*task.physical, report.variable);
}

std::string report_text(const BeliefTask& task, const ConditionalPlan::Report& report) {
    const std::string atom = report_atom(task, report.variable);
    if (report.value == ConditionalPlan::Report::kSilent) return "nothing about " + atom;
    if (report_holds(task, report)) return atom;
    const FiniteDomainTask& physical = *task.physical;
    const Fact fact{report.variable, report.value};
    if (!physical.is_atom(fact)) return "not " + atom;
    return "(" + physical.fact_names.words(physical.fact_number(fact)) + ")";
}

std::vector<PlanBlock> plan_blocks(const BeliefTask& task, const ConditionalPlan& plan) {
    std::vector<PlanBlock> blocks;
    if (plan.size() == 0 || plan.goal(0)) return blocks;
    const std::vector<bool> starts = block_starts(plan);
    std::vector<std::uint32_t> numbers(plan.size(), PlanBlock::kGoal);
    std::uint32_t count = 0;
    for (std::uint32_t node = 0; node < plan.size(); ++node)
        if (starts[node] && !plan.goal(node)) numbers[node] = count++;
    for (std::uint32_t first = 0; first < plan.size(); ++first) {
        if (numbers[first] == PlanBlock::kGoal) continue;
        PlanBlock& block = blocks.emplace_back();
        std::uint32_t node = first;
        for (;;) {
            if (plan.action(node) != Environment::kStart)
                block.actions.push_back(task.physical->operator_name(OperatorId(plan.action(node))));
            const auto edges = plan.edges(node);
            const std::uint32_t next = edges.front().target;
            if (edges.size() > 1 || starts[next] || plan.goal(next)) break;
            node = next;
        }
        for (const ConditionalPlan::Edge& edge : plan.edges(node)) {
            PlanBlock::Choice& choice = block.choices.emplace_back();
            choice.target = numbers[edge.target];
            for (const ConditionalPlan::Report& report : plan.reports(edge))
                choice.answers.push_back(report_text(task, report));
        }
    }
    return blocks;
}

}  // namespace praxis::belief
