#include "belief/check_run.hpp"

#include "belief/atom_names.hpp"
#include "search/plan_names.hpp"

namespace praxis::belief {

Verdict check_run(const BeliefTask& task, const WorldState& first,
                  const std::vector<std::uint32_t>& actions) {
    const FiniteDomainTask& physical = *task.physical;
    LiftedTask world = *task.source->task;
    const AtomNames atoms(task);
    for (std::size_t v = 0; v < first.size(); ++v) {
        if (task.initial_values[v] != BeliefTask::kUnknown) continue;
        const auto literal = atoms.literal({static_cast<std::int32_t>(v), first[v]});
        if (!literal || literal->negated) continue;
        Relation& relation = world.initial_atoms[literal->predicate.index()];
        relation.arguments.insert(relation.arguments.end(), literal->arguments.begin(),
                                  literal->arguments.end());
        ++relation.count;
    }
    const PlanNames names(*task.lifted, physical);
    std::vector<OperatorId> operators;
    for (std::uint32_t action : actions) operators.emplace_back(action);
    return validate(world, names.plan(operators, 0));
}

}  // namespace praxis::belief
