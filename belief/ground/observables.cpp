#include "belief/ground/observables.hpp"

#include "search/ground/refuse.hpp"

namespace praxis::belief {
namespace {

/// The first atom of the formula that has one of the predicates, or nullptr.
const Formula* find(const Formula& formula, const std::vector<bool>& predicates) {
    if (formula.kind == Connective::atom) return predicates[formula.predicate.index()] ? &formula : nullptr;
    for (const Formula& child : formula.children)
        if (const Formula* found = find(child, predicates)) return found;
    return nullptr;
}

class Finder {
  public:
    explicit Finder(const ContingentTask& task) : task_(task) {
        found_.all.assign(task.task->predicates.size(), false);
        found_.asked = found_.all;
        for (const MultiValuedVariable& variable : task.variables)
            if (variable.observable)
                for (const GroundLiteral& value : variable.values) found_.all[value.predicate.index()] = true;
    }

    Observables operator()() {
        check_models();
        check_effects();
        check_initial();
        collect_asked();
        return found_;
    }

  private:
    [[noreturn]] void refuse(Location where, const char* message) const {
        grounding::refuse(*task_.task, where, message);
    }

    void check_models() const {
        const auto check = [&](const auto& parts) {
            for (const auto& part : parts)
                if (const Formula* found = find(part.condition, found_.all))
                    refuse(found->where, "an observable atom in the condition of a sensing model");
        };
        for (const SchemaSensing& sensing : task_.sensing) {
            check(sensing.model);
            check(sensing.observations);
        }
        check(task_.default_model);
        check(task_.default_observations);
    }

    void check_effects() const {
        const auto check = [&](const std::vector<Effect>& effects) {
            for (const Effect& effect : effects)
                if (found_.all[effect.predicate.index()])
                    refuse(effect.where, "an effect on an observable atom; sensing models say what it is");
        };
        for (const Schema& schema : task_.task->schemas) check(schema.effects);
        for (const SchemaSensing& sensing : task_.sensing) check(sensing.forgotten);
    }

    void check_initial() const {
        const auto check = [&](const std::vector<GroundLiteral>& literals) {
            for (const GroundLiteral& literal : literals)
                if (found_.all[literal.predicate.index()])
                    refuse(literal.where, "an observable atom in ':init'; sensing models say what it is");
        };
        check(task_.unknown);
        check(task_.known_false);
        for (const Clause& clause : task_.clauses) check(clause.literals);
        for (std::size_t p = 0; p < found_.all.size(); ++p)
            if (found_.all[p] && task_.task->initial_atoms[p].count > 0)
                refuse(task_.task->predicates[p].where,
                       "an observable predicate with atoms in ':init'; sensing models say what they are");
    }

    void collect_asked() {
        const auto ask = [&](const auto& self, const Formula& formula) -> void {
            if (formula.kind == Connective::atom && found_.all[formula.predicate.index()])
                found_.asked[formula.predicate.index()] = true;
            for (const Formula& child : formula.children) self(self, child);
        };
        for (const Schema& schema : task_.task->schemas) {
            ask(ask, schema.precondition);
            for (const Effect& effect : schema.effects) ask(ask, effect.condition);
        }
        for (const Axiom& axiom : task_.task->axioms) ask(ask, axiom.body);
        for (const Sensor& sensor : task_.sensors) ask(ask, sensor.condition);
        ask(ask, task_.task->goal);
    }

    const ContingentTask& task_;
    Observables found_;
};

}  // namespace

Observables find_observables(const ContingentTask& task) {
    return Finder(task)();
}

}  // namespace praxis::belief
