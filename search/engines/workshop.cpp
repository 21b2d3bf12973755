#include <algorithm>
#include <stdexcept>

#include "search/engines/registry.hpp"
#include "search/engines/search_plan.hpp"

namespace praxis {

namespace {

/// Whether costs counted as `cost_type` are never more than the task's.
bool below_real_costs(const FiniteDomainTask& task, CostType cost_type) {
    const auto [least, most] = std::minmax_element(task.costs.begin(), task.costs.end());
    switch (cost_type) {
        case CostType::normal:
            return true;
        case CostType::one:
            return task.costs.empty() || *least >= 1;
        case CostType::plus_one:
            return task.costs.empty() || (*least == 1 && *most == 1);
    }
    return false;
}

}  // namespace

SearchPlan Workshop::search_plan(const Call& call) {
    return call.component->search_plan(call, *this);
}
Key Workshop::key(const Call& call) {
    return call.component->key(call, *this);
}
OpenListPlan Workshop::open_list(const Call& call) {
    return call.component->open_list(call, *this);
}

std::vector<Key> Workshop::keys(const Argument& argument) {
    std::vector<Key> result;
    for (const Call& call : argument.calls) result.push_back(key(call));
    return result;
}

std::vector<OpenListPlan> Workshop::open_lists(const Argument& argument) {
    std::vector<OpenListPlan> result;
    for (const Call& call : argument.calls) result.push_back(open_list(call));
    return result;
}

std::vector<std::size_t> Workshop::heuristics_in(const Argument& argument) {
    std::vector<std::size_t> numbers;
    for (const Key& key : keys(argument)) key.collect_heuristics(numbers);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

bool Workshop::admissible(const Key& key) const {
    std::vector<bool> each;
    for (const Heuristic& heuristic : heuristics_) {
        each.push_back(heuristic.evaluator->admissible() && below_real_costs(*task_, heuristic.cost_type));
    }
    return key.admissible(each);
}

const std::vector<Component>& components() {
    static const std::vector<Component> all = [] {
        std::vector<Component> result = evaluator_components();
        for (auto* more : {open_list_components, engine_components}) {
            for (Component& component : more()) result.push_back(std::move(component));
        }
        return result;
    }();
    return all;
}

std::vector<ComponentDescription> list_components() {
    std::vector<ComponentDescription> result;
    for (const Component& component : components()) result.push_back(component.description);
    return result;
}

OptionDescription cost_type_option(std::string default_value, std::string help) {
    return {"cost_type",
            OptionType::choice,
            std::move(default_value),
            std::move(help),
            {"normal", "one", "plusone"}};
}

CostType cost_type_of(const Call& call) {
    return static_cast<CostType>(call.integer("cost_type"));
}

}  // namespace praxis
