#include "belief/check_run.hpp"

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "belief/ground/observable_axioms.hpp"
#include "belief/ground/observables.hpp"
#include "search/plan_names.hpp"

namespace praxis::belief {
namespace {

using Tuple = std::vector<ObjectId>;

/// The task as it is written, from states of the physical one.
class WrittenTask {
  public:
    explicit WrittenTask(const BeliefTask& task)
        : task_(task), world_(with_observable_axioms(*task.source)), written_(world_.initial_atoms) {
        const std::vector<bool> observable = find_observables(*task.source).all;
        for (std::size_t p = 0; p < world_.predicates.size(); ++p)
            if (!observable[p] && !world_.predicates[p].derived)
                predicates_.emplace(world_.predicates[p].name, p);
        for (std::size_t o = 0; o < world_.objects.size(); ++o) objects_.emplace(world_.objects[o].name, o);
    }

    /// With the atoms that hold in the state, and those that no state of the physical task speaks of.
    const LiftedTask& from(const WorldState& state) {
        std::vector<std::set<Tuple>> holding(written_.size()), failing(written_.size());
        const FiniteDomainTask& physical = *task_.physical;
        for (std::size_t v = 0; v < state.size(); ++v) {
            for (std::int32_t value = 0; value < physical.domain_sizes[v]; ++value) {
                const std::uint32_t fact = physical.fact_number({static_cast<std::int32_t>(v), value});
                const auto words = physical.fact_names.names[fact];
                if (!physical.is_atom({static_cast<std::int32_t>(v), value}) || words.empty()) continue;
                const auto predicate = predicates_.find(physical.fact_names.symbols[words[0]]);
                if (predicate == predicates_.end()) continue;
                Tuple arguments;
                for (std::uint32_t word : words.subspan(1))
                    arguments.emplace_back(objects_.at(physical.fact_names.symbols[word]));
                (value == state[v] ? holding : failing)[predicate->second].insert(std::move(arguments));
            }
        }
        for (std::size_t p = 0; p < written_.size(); ++p) {
            for (std::size_t i = 0; i < written_[p].count; ++i) {
                const auto tuple = written_[p].tuple(i);
                Tuple arguments(tuple.begin(), tuple.end());
                if (!failing[p].contains(arguments)) holding[p].insert(std::move(arguments));
            }
            Relation& relation = world_.initial_atoms[p];
            relation.arguments.clear();
            for (const Tuple& tuple : holding[p])
                relation.arguments.insert(relation.arguments.end(), tuple.begin(), tuple.end());
            relation.count = holding[p].size();
        }
        return world_;
    }

  private:
    const BeliefTask& task_;
    LiftedTask world_;
    std::vector<Relation> written_;
    std::unordered_map<std::string_view, std::size_t> predicates_, objects_;
};

}  // namespace

Verdict check_run(const BeliefTask& task, const WorldState& first, const std::vector<std::uint32_t>& actions,
                  std::span<const WorldState> after_chance) {
    WrittenTask written(task);
    const PlanNames names(*task.lifted, *task.physical);
    const WorldState* state = &first;
    std::vector<OperatorId> part;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        part.emplace_back(actions[i]);
        if (task.forgotten[actions[i]].empty()) continue;
        if (after_chance.empty()) throw std::invalid_argument("a state is missing after an action of chance");
        LiftedTask without_goal = written.from(*state);
        without_goal.goal = Formula();
        Verdict verdict = validate(without_goal, names.plan(part, 0));
        if (!verdict.valid) return verdict;
        state = &after_chance.front();
        after_chance = after_chance.subspan(1);
        part.clear();
    }
    return validate(written.from(*state), names.plan(part, 0));
}

}  // namespace praxis::belief
