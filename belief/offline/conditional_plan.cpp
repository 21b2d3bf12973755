#include "belief/offline/conditional_plan.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace praxis::belief {
namespace {

using Report = ConditionalPlan::Report;

bool fits(std::span<const Report> reports, std::span<const Fact> answers) {
    return std::all_of(reports.begin(), reports.end(), [&](const Report& report) {
        const auto answer = std::find_if(answers.begin(), answers.end(),
                                         [&](const Fact& fact) { return fact.variable == report.variable; });
        return (answer == answers.end() ? Report::kSilent : answer->value) == report.value;
    });
}

std::int32_t answered(const std::vector<Fact>& observation, std::int32_t variable) {
    const auto place = std::lower_bound(observation.begin(), observation.end(), Fact{variable, 0});
    return place != observation.end() && place->variable == variable ? place->value : Report::kSilent;
}

/// The variables about which not all edges say the same.
std::vector<std::int32_t> telling(const std::vector<PlanDraft::Edge>& edges) {
    std::set<std::int32_t> variables;
    for (const PlanDraft::Edge& edge : edges)
        for (const Fact& fact : edge.observation) variables.insert(fact.variable);
    std::vector<std::int32_t> result;
    for (std::int32_t variable : variables) {
        const std::int32_t first = answered(edges.front().observation, variable);
        if (std::any_of(edges.begin(), edges.end(), [&](const PlanDraft::Edge& edge) {
                return answered(edge.observation, variable) != first;
            }))
            result.push_back(variable);
    }
    return result;
}

}  // namespace

std::optional<std::uint32_t> ConditionalPlan::next(std::uint32_t node, std::span<const Fact> answers) const {
    for (const Edge& edge : edges(node))
        if (fits(reports(edge), answers)) return edge.target;
    return std::nullopt;
}

std::size_t ConditionalPlan::action_nodes() const {
    return static_cast<std::size_t>(std::count_if(actions_.begin(), actions_.end(), [](std::uint32_t action) {
        return action != kGoal && action != Environment::kStart;
    }));
}

std::size_t ConditionalPlan::depth() const {
    std::vector<std::size_t> depths(size(), 0);
    for (std::uint32_t node = static_cast<std::uint32_t>(size()); node-- > 0;) {
        for (const Edge& edge : edges(node)) depths[node] = std::max(depths[node], depths[edge.target]);
        depths[node] += actions_[node] != kGoal && actions_[node] != Environment::kStart;
    }
    return depths.empty() ? 0 : depths[0];
}

PlanDraft::PlanDraft() {
    nodes_.push_back({ConditionalPlan::kGoal, {}});
}

std::size_t PlanDraft::Hash::operator()(const Node& node) const {
    std::uint64_t hash = node.action;
    const auto mix = [&](std::uint64_t value) {
        hash = (hash ^ value ^ (hash >> 29)) * 0x9e3779b97f4a7c15ULL;
    };
    for (const Choice& choice : node.choices) {
        mix(choice.target);
        for (const Report& report : choice.reports) {
            mix(static_cast<std::uint64_t>(report.variable));
            mix(static_cast<std::uint64_t>(report.value) + 7);
        }
    }
    return static_cast<std::size_t>(hash);
}

std::uint32_t PlanDraft::add(std::uint32_t action, const std::vector<Edge>& edges) {
    Node node{action, {}};
    const bool choice = std::any_of(edges.begin(), edges.end(),
                                    [&](const Edge& edge) { return edge.target != edges.front().target; });
    if (!choice) {
        node.choices.push_back({{}, edges.front().target});
    } else {
        const std::vector<std::int32_t> variables = telling(edges);
        for (const Edge& edge : edges) {
            Choice& made = node.choices.emplace_back();
            made.target = edge.target;
            for (std::int32_t variable : variables)
                made.reports.push_back({variable, answered(edge.observation, variable)});
        }
        std::sort(node.choices.begin(), node.choices.end());
    }
    const auto [place, fresh] = index_.emplace(node, static_cast<std::uint32_t>(nodes_.size()));
    if (fresh) nodes_.push_back(std::move(node));
    return place->second;
}

std::optional<std::uint32_t> PlanDraft::next(std::uint32_t node, std::span<const Fact> answers) const {
    for (const Choice& choice : nodes_[node].choices)
        if (fits(choice.reports, answers)) return choice.target;
    return std::nullopt;
}

ConditionalPlan PlanDraft::finish(std::uint32_t first) const {
    // Nodes lead to nodes with smaller numbers: from the greatest down, every node comes after those that
    // lead to it.
    std::vector<bool> used(nodes_.size(), false);
    used[first] = true;
    std::vector<std::uint32_t> numbers(nodes_.size(), 0);
    std::vector<std::uint32_t> order;
    for (std::uint32_t node = first + 1; node-- > 0;) {
        if (!used[node]) continue;
        numbers[node] = static_cast<std::uint32_t>(order.size());
        order.push_back(node);
        for (const Choice& choice : nodes_[node].choices) used[choice.target] = true;
    }
    ConditionalPlan plan;
    for (std::uint32_t node : order) {
        plan.actions_.push_back(nodes_[node].action);
        for (const Choice& choice : nodes_[node].choices) {
            plan.edges_.add({numbers[choice.target], static_cast<std::uint32_t>(plan.reports_.size())});
            plan.reports_.append(choice.reports);
        }
        plan.edges_.close();
    }
    return plan;
}

}  // namespace praxis::belief
