#include "search/plan_names.hpp"

#include <string_view>
#include <unordered_map>

namespace praxis {
namespace {

/// By symbol: the index of the item with that name, or of the invalid id.
template <class Items>
std::vector<std::uint32_t> resolve(const std::vector<std::string>& symbols, const Items& items) {
    std::unordered_map<std::string_view, std::uint32_t> index;
    index.reserve(items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) index.emplace(items[i].name, i);
    std::vector<std::uint32_t> result;
    result.reserve(symbols.size());
    for (const std::string& symbol : symbols) {
        const auto found = index.find(symbol);
        result.push_back(found == index.end() ? ObjectId().index() : found->second);
    }
    return result;
}

}  // namespace

PlanNames::PlanNames(const LiftedTask& lifted, const FiniteDomainTask& ground)
    : ground_(ground),
      schemas_(resolve(ground.operator_names.symbols, lifted.schemas)),
      objects_(resolve(ground.operator_names.symbols, lifted.objects)) {}

Plan PlanNames::plan(std::span<const OperatorId> operators, std::int64_t cost) const {
    Plan result;
    result.steps.reserve(operators.size());
    for (OperatorId id : operators) {
        const auto words = ground_.operator_names.names[id.index()];
        PlanStep step;
        step.schema = SchemaId(schemas_[words[0]]);
        for (std::uint32_t word : words.subspan(1)) step.arguments.emplace_back(objects_[word]);
        result.steps.push_back(std::move(step));
    }
    result.cost = ground_.unit_cost ? Rational(static_cast<std::int64_t>(operators.size()))
                                    : Rational(cost, ground_.cost_scale);
    return result;
}

}  // namespace praxis
