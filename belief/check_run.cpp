#include "belief/check_run.hpp"

#include <memory>
#include <string_view>
#include <unordered_map>

#include "belief/ground/observable_axioms.hpp"
#include "belief/ground/observables.hpp"
#include "search/plan_names.hpp"

namespace praxis::belief {

Verdict check_run(const BeliefTask& task, const WorldState& first,
                  const std::vector<std::uint32_t>& actions) {
    const FiniteDomainTask& physical = *task.physical;
    LiftedTask world = with_observable_axioms(*task.source);
    const std::vector<bool> observable = find_observables(*task.source).all;
    std::unordered_map<std::string_view, std::size_t> predicates, objects;
    for (std::size_t p = 0; p < world.predicates.size(); ++p) predicates.emplace(world.predicates[p].name, p);
    for (std::size_t o = 0; o < world.objects.size(); ++o) objects.emplace(world.objects[o].name, o);
    for (std::size_t v = 0; v < first.size(); ++v) {
        if (task.initial_values[v] != BeliefTask::kUnknown) continue;
        const std::uint32_t fact = physical.fact_number({static_cast<std::int32_t>(v), first[v]});
        if (physical.fact_forms[fact] != FiniteDomainTask::FactForm::atom) continue;
        const auto words = physical.fact_names.names[fact];
        const std::size_t predicate = predicates.at(physical.fact_names.symbols[words[0]]);
        if (observable[predicate]) continue;
        Relation& relation = world.initial_atoms[predicate];
        for (std::uint32_t word : words.subspan(1))
            relation.arguments.emplace_back(objects.at(physical.fact_names.symbols[word]));
        ++relation.count;
    }
    const PlanNames names(*task.lifted, physical);
    std::vector<OperatorId> operators;
    for (std::uint32_t action : actions) operators.emplace_back(action);
    return validate(world, names.plan(operators, 0));
}

}  // namespace praxis::belief
