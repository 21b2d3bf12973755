#include "tamp/refine/symbolic.hpp"

#include <algorithm>
#include <utility>

#include "search/ground/ground.hpp"

namespace praxis::tamp {

SymbolicTask::SymbolicTask(OptimisticTask optimistic, const std::vector<bool>& certified,
                           const Budget& budget)
    : optimistic_(std::move(optimistic)), rules_(*optimistic_.task, certified) {
    GroundOptions options;
    options.prune_irrelevant = false;  // what is learned may make any fact matter
    ground_ = praxis::ground(*optimistic_.task, options, budget).task;
    if (!ground_) return;
    atoms_.emplace(*optimistic_.task, *ground_);
    names_.emplace(*optimistic_.task, *ground_);
    find_shared();
}

void SymbolicTask::find_shared() {
    shared_.assign(lifted().objects.size(), false);
    for (std::size_t variable = 0; variable < ground_->variable_count(); ++variable) {
        if (ground_->axiom_layers[variable] >= 0) continue;
        for (std::uint32_t fact = ground_->first_fact[variable]; fact < ground_->first_fact[variable + 1];
             ++fact)
            for (const std::uint32_t word : ground_->fact_names.names[fact])
                if (word < shared_.size() && optimistic_.producer[word] != OptimisticTask::kNone)
                    shared_[word] = true;
    }
    // An instance's inputs come before its outputs.
    for (std::size_t i = optimistic_.instances.size(); i-- > 0;) {
        const StreamInstance& instance = optimistic_.instances[i];
        const auto is_shared = [&](ObjectId object) { return shared_[object.index()]; };
        if (std::ranges::none_of(instance.outputs, is_shared)) continue;
        for (const ObjectId object : instance.outputs) shared_[object.index()] = true;
        for (const ObjectId object : instance.inputs)
            shared_[object.index()] = optimistic_.producer[object.index()] != OptimisticTask::kNone;
    }
}

std::optional<Fact> SymbolicTask::fact(const GroundAtom& atom, bool& known) const {
    std::vector<ObjectId> arguments;
    for (std::size_t i = 1; i < atom.size(); ++i) arguments.emplace_back(atom[i]);
    const std::uint32_t number = atoms_->find(PredicateId(atom[0]), arguments);
    if (number == AtomIndex::kAbsent) {
        known = false;
        return std::nullopt;
    }
    const AtomIndex::Entry& entry = (*atoms_)[number];
    if (entry.kind != AtomIndex::Entry::Kind::fact) return std::nullopt;
    return entry.fact;
}

SymbolicTask::Found SymbolicTask::plan(std::span<const Nogood> nogoods, const Configuration& configuration,
                                       const Budget& budget) const {
    Found found;
    if (ground_->proved_unsolvable) {
        found.status = Status::unsolvable_early;
        return found;
    }
    const PreparedTask prepared(nogoods.empty() ? ground_ : restrict(*ground_, nogoods), budget);
    Outcome outcome = search(prepared, task_query(prepared.task()), configuration, budget);
    found.status = outcome.status;
    found.evaluated = outcome.statistics.evaluated;
    if (!outcome.plan) return found;
    Plan plan = names_->plan(*outcome.plan, outcome.cost);
    found.plan = {std::move(*outcome.plan), std::move(plan.steps)};
    return found;
}

}  // namespace praxis::tamp
