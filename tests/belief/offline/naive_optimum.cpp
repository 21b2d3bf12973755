#include "naive_optimum.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "belief/simulated_world.hpp"

namespace praxis::belief::testing {
namespace {

using NaiveBelief = std::map<WorldState, std::int64_t>;  // how many first states led to each
using Observation = std::set<Fact>;

std::map<Observation, NaiveBelief> after(const std::shared_ptr<const BeliefTask>& task,
                                         const NaiveBelief& belief, std::uint32_t action) {
    std::map<Observation, NaiveBelief> result;
    for (const auto& [state, count] : belief) {
        SimulatedWorld world(task, state);
        if (action != Environment::kStart && world.execute(action).status != Execution::Status::done)
            return {};
        Observation observation;
        for (const Answer& answer : world.observe(action)) observation.insert(answer.fact);
        result[observation][world.state()] += count;
    }
    return result;
}

struct Choice {
    std::int64_t cost;
    std::vector<std::size_t> parts;
};

}  // namespace

std::optional<NaiveOptimum> naive_optimum(const std::shared_ptr<const BeliefTask>& task, bool worst,
                                          std::size_t most) {
    NaiveBelief first;
    const auto worlds = enumerate_worlds(*task, 1000);
    for (const WorldState& world : *worlds) first[SimulatedWorld(task, world).state()] += 1;
    std::map<NaiveBelief, std::size_t> numbers;
    std::vector<NaiveBelief> beliefs;
    const auto number = [&](const NaiveBelief& belief) {
        const auto place = numbers.emplace(belief, beliefs.size());
        if (place.second) beliefs.push_back(belief);
        return place.first->second;
    };
    std::vector<std::size_t> starts;
    for (const auto& [observation, part] : after(task, first, Environment::kStart))
        starts.push_back(number(part));
    std::vector<std::vector<Choice>> choices;
    for (std::size_t b = 0; b < beliefs.size(); ++b) {
        if (beliefs.size() > most) return std::nullopt;
        choices.emplace_back();
        std::int64_t weight = 0;
        for (const auto& [state, count] : beliefs[b]) weight += count;
        for (std::uint32_t action = 0; action < task->operator_count(); ++action) {
            const NaiveBelief belief = beliefs[b];
            Choice choice{task->physical->costs[action] * (worst ? 1 : weight), {}};
            for (const auto& [observation, part] : after(task, belief, action))
                choice.parts.push_back(number(part));
            if (!choice.parts.empty()) choices.back().push_back(choice);
        }
    }
    constexpr std::int64_t kNever = 1'000'000'000;
    const auto sum = [&](const std::vector<std::int64_t>& costs, const std::vector<std::size_t>& parts) {
        std::int64_t total = 0;
        for (std::size_t part : parts) total = worst ? std::max(total, costs[part]) : total + costs[part];
        return std::min(total, kNever);
    };
    std::vector<std::int64_t> costs(beliefs.size(), kNever);
    for (std::size_t b = 0; b < beliefs.size(); ++b)
        if (std::all_of(beliefs[b].begin(), beliefs[b].end(), [&](const auto& entry) {
                return all_hold(task->physical->goal, entry.first.data());
            }))
            costs[b] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t b = 0; b < beliefs.size(); ++b) {
            for (const Choice& choice : choices[b]) {
                const std::int64_t cost = choice.cost + sum(costs, choice.parts);
                if (cost >= kNever || cost >= costs[b]) continue;
                costs[b] = cost;
                changed = true;
            }
        }
    }
    NaiveOptimum result;
    if (const std::int64_t cost = sum(costs, starts); cost < kNever) result.cost = cost;
    return result;
}

}  // namespace praxis::belief::testing
