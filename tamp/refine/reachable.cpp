#include "tamp/refine/reachable.hpp"

#include <algorithm>

namespace praxis::tamp {
namespace {

bool has_equality(const Formula& formula) {
    return formula.kind == Connective::equality || std::ranges::any_of(formula.children, has_equality);
}

class Relaxation {
  public:
    explicit Relaxation(const FiniteDomainTask& task) : task_(task), reached_(task.fact_count(), false) {
        for (std::size_t v = 0; v < task.variable_count(); ++v)
            reach({static_cast<std::int32_t>(v), task.initial_values[v]});
    }

    bool run(const std::vector<bool>& forbidden) {
        for (bool more = true; more && !holds(task_.goal);) {
            const std::size_t before = count_;
            for (std::size_t op = 0; op < task_.operator_count(); ++op) {
                if (forbidden[op] || !holds(task_.preconditions[op])) continue;
                for (const GroundEffect& effect : task_.effects[op])
                    if (holds(task_.conditions[effect.condition])) reach(effect.fact);
            }
            for (std::size_t axiom = 0; axiom < task_.axioms.size(); ++axiom)
                if (holds(task_.axiom_bodies[axiom])) reach(task_.axioms[axiom].head);
            more = count_ > before;
        }
        return holds(task_.goal);
    }

  private:
    void reach(Fact fact) {
        const std::uint32_t number = task_.fact_number(fact);
        count_ += reached_[number] ? 0 : 1;
        reached_[number] = true;
    }
    bool holds(std::span<const Fact> facts) const {
        return std::ranges::all_of(facts, [&](const Fact& fact) { return reached_[task_.fact_number(fact)]; });
    }

    const FiniteDomainTask& task_;
    std::vector<bool> reached_;
    std::size_t count_ = 0;
};

}  // namespace

bool is_goal_reachable(const FiniteDomainTask& task, const std::vector<bool>& forbidden) {
    return Relaxation(task).run(forbidden);
}

bool is_free_of_equality(const LiftedTask& task) {
    const auto asks = [](const Schema& schema) {
        return has_equality(schema.precondition) ||
               std::ranges::any_of(schema.effects, has_equality, &Effect::condition);
    };
    return std::ranges::none_of(task.schemas, asks) &&
           std::ranges::none_of(task.axioms, [](const Axiom& axiom) { return has_equality(axiom.body); });
}

}  // namespace praxis::tamp
