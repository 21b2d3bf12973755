#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "belief/augment.hpp"
#include "belief/belief_task.hpp"
#include "search/ground/ground.hpp"
#include "search/ground/refuse.hpp"

namespace praxis::belief {
namespace {

/// What the ground task says about an atom.
struct Place {
    enum class Kind { fact, always, never };
    Kind kind = Kind::never;
    Fact fact;
};

class Grounder {
  public:
    Grounder(std::shared_ptr<const ContingentTask> source, Augmented augmented,
             std::shared_ptr<const FiniteDomainTask> ground)
        : source_(std::move(source)),
          augmented_(std::move(augmented)),
          ground_(std::move(ground)),
          atoms_(std::make_shared<AtomIndex>(*augmented_.task, *ground_)),
          names_(*augmented_.task, *ground_),
          task_(std::make_shared<BeliefTask>()) {}

    std::shared_ptr<const BeliefTask> operator()() {
        task_->source = source_;
        task_->lifted = augmented_.task;
        task_->atoms = atoms_;
        add_initial_values();
        split_operators();
        task_->physical = physical_;
        mark_uncertain();
        if (physical_->proved_unsolvable) return std::move(task_);  // nearly nothing is left to speak of
        add_initial_clauses();
        add_worlds();
        return std::move(task_);
    }

  private:
    [[noreturn]] void refuse(Location where, std::string message) const {
        grounding::refuse(*source_->task, where, std::move(message));
    }

    Place place(PredicateId predicate, std::span<const ObjectId> arguments) const {
        std::uint32_t number = atoms_->find(predicate, arguments);
        if (number == AtomIndex::kAbsent) return {Place::Kind::never, {}};
        if ((*atoms_)[number].kind != AtomIndex::Entry::Kind::fact) return {Place::Kind::always, {}};
        // Of several variables that have the atom, one with two values can be uncertain.
        const std::uint32_t first = number;
        for (; number != AtomIndex::kAbsent; number = (*atoms_)[number].next)
            if (ground_->domain_sizes[static_cast<std::size_t>((*atoms_)[number].fact.variable)] == 2)
                return {Place::Kind::fact, (*atoms_)[number].fact};
        return {Place::Kind::fact, (*atoms_)[first].fact};
    }
    Place place(const GroundLiteral& literal) const {
        Place result = place(literal.predicate, literal.arguments);
        if (!literal.negated) return result;
        switch (result.kind) {
            case Place::Kind::always:
                return {Place::Kind::never, {}};
            case Place::Kind::never:
                return {Place::Kind::always, {}};
            case Place::Kind::fact:
                break;
        }
        if (ground_->domain_sizes[static_cast<std::size_t>(result.fact.variable)] != 2)
            refuse(literal.where, "a negative literal about an atom that is one of several values");
        result.fact.value = 1 - result.fact.value;
        return result;
    }

    void add_initial_values() {
        task_->initial_values = ground_->initial_values;
        for (std::size_t p = 0; p < augmented_.uncertain.size(); ++p) {
            const Relation& relation = augmented_.uncertain[p];
            for (std::size_t i = 0; i < relation.count; ++i) {
                const Place where = place(PredicateId(p), relation.tuple(i));
                if (where.kind == Place::Kind::fact)
                    task_->initial_values[static_cast<std::size_t>(where.fact.variable)] =
                        BeliefTask::kUnknown;
            }
        }
    }

    /// Operators of the source stay operators, those of sensors become sensors, the auxiliary ones go.
    void split_operators() {
        auto physical = std::make_shared<FiniteDomainTask>();
        physical->domain_sizes = ground_->domain_sizes;
        physical->axiom_layers = ground_->axiom_layers;
        physical->initial_values = ground_->initial_values;
        physical->first_fact = ground_->first_fact;
        physical->fact_names = ground_->fact_names;
        physical->fact_forms = ground_->fact_forms;
        physical->conditions = ground_->conditions;
        physical->axioms = ground_->axioms;
        physical->axiom_bodies = ground_->axiom_bodies;
        physical->goal = ground_->goal;
        physical->mutex_groups = ground_->mutex_groups;
        physical->unit_cost = ground_->unit_cost;
        physical->cost_scale = ground_->cost_scale;
        physical->proved_unsolvable = ground_->proved_unsolvable;
        physical->operator_names.symbols = ground_->operator_names.symbols;
        const std::vector<bool> auxiliary = auxiliary_variables();
        for (std::size_t o = 0; o < ground_->operator_count(); ++o) {
            const OperatorId id(o);
            const Plan plan = names_.plan({&id, 1}, 0);
            const PlanStep& step = plan.steps.front();
            if (step.schema.index() >= augmented_.first_sensor) {
                add_sensor(o, step);
            } else if (step.schema.index() < augmented_.schemas) {
                physical->preconditions.append(ground_->preconditions[o]);
                for (const GroundEffect& effect : ground_->effects[o])
                    if (!auxiliary[static_cast<std::size_t>(effect.fact.variable)])
                        physical->effects.add(effect);
                physical->effects.close();
                physical->costs.push_back(ground_->costs[o]);
                physical->operator_names.names.append(ground_->operator_names.names[o]);
                add_sensing(step);
            }
        }
        physical_ = std::move(physical);
    }

    /// Of the atom that only keeps sensing schemas alive.
    std::vector<bool> auxiliary_variables() const {
        std::vector<bool> result(ground_->variable_count(), false);
        for (std::size_t v = 0; v < result.size(); ++v) {
            const auto words = ground_->fact_names.names[ground_->first_fact[v]];
            result[v] = !words.empty() && ground_->fact_names.symbols[words[0]] == "@sense";
        }
        return result;
    }

    /// Calls visit(reading) for every reading that an observation of a ground action gives.
    template <class Visit>
    void for_each_reading(const Observation& observation, const Scope& scope,
                          const std::vector<ObjectId>& arguments, Visit visit) const {
        std::vector<ObjectId> binding(scope.variable_types.size());
        std::copy(arguments.begin(), arguments.end(), binding.begin());
        bind(observation, scope, binding, 0, visit);
    }
    template <class Visit>
    void bind(const Observation& observation, const Scope& scope, std::vector<ObjectId>& binding,
              std::size_t next, const Visit& visit) const {
        if (next < observation.variables.size()) {
            const std::uint32_t variable = observation.variables[next];
            for (ObjectId object : source_->task->types[scope.variable_types[variable].index()].objects) {
                binding[variable] = object;
                bind(observation, scope, binding, next + 1, visit);
            }
            return;
        }
        if (!static_truth(observation.condition, binding)) return;
        const Place where = place(observation.predicate, resolve(observation.terms, binding));
        if (where.kind == Place::Kind::fact) visit(GroundReading{where.fact, observation.accuracy});
    }

    static std::vector<ObjectId> resolve(const std::vector<Term>& terms,
                                         const std::vector<ObjectId>& binding) {
        std::vector<ObjectId> result;
        for (const Term& term : terms)
            result.push_back(term.is_variable() ? binding[term.variable_index()] : term.object_id());
        return result;
    }

    bool static_truth(const Formula& formula, const std::vector<ObjectId>& binding) const {
        switch (formula.kind) {
            case Connective::truth:
                return true;
            case Connective::falsity:
                return false;
            case Connective::equality: {
                const std::vector<ObjectId> objects = resolve(formula.terms, binding);
                return objects[0] == objects[1];
            }
            case Connective::negation:
                return !static_truth(formula.children[0], binding);
            case Connective::conjunction:
                return std::all_of(formula.children.begin(), formula.children.end(),
                                   [&](const Formula& child) { return static_truth(child, binding); });
            case Connective::disjunction:
                return std::any_of(formula.children.begin(), formula.children.end(),
                                   [&](const Formula& child) { return static_truth(child, binding); });
            case Connective::atom: {
                const Place where = place(formula.predicate, resolve(formula.terms, binding));
                if (where.kind == Place::Kind::fact)
                    refuse(formula.where, "what is observed depends on a condition that can change");
                return where.kind == Place::Kind::always;
            }
            default:
                refuse(formula.where, "a condition of an observation with quantifiers or implications");
        }
    }

    void add_sensing(const PlanStep& step) {
        const Schema& schema = source_->task->schemas[step.schema.index()];
        const SchemaSensing& sensing = source_->sensing[step.schema.index()];
        for (const Observation& observation : sensing.observations) {
            for_each_reading(observation, schema.scope, step.arguments, [&](const GroundReading& reading) {
                check_readable(reading.fact, observation.where);
                task_->readings.add(reading);
            });
        }
        task_->readings.close();
        for (const Effect& effect : sensing.forgotten) {
            const Observation atom{effect.variables, effect.condition, effect.predicate, effect.terms, 1,
                                   effect.where};
            for_each_reading(atom, schema.scope, step.arguments, [&](const GroundReading& reading) {
                task_->forgotten.add(reading.fact.variable);
            });
        }
        task_->forgotten.close();
    }

    void add_sensor(std::size_t o, const PlanStep& step) {
        const Sensor& sensor = source_->sensors[step.schema.index() - augmented_.first_sensor];
        std::string name = "(" + sensor.name;
        for (ObjectId object : step.arguments) name += " " + source_->task->objects[object.index()].name;
        name += ")";
        for (const Observation& observation : sensor.observations) {
            for_each_reading(observation, sensor.scope, step.arguments, [&](const GroundReading& reading) {
                check_readable(reading.fact, observation.where);
                task_->sensors.push_back({name, reading});
                task_->sensor_conditions.append(ground_->preconditions[o]);
            });
        }
    }

    void check_readable(Fact fact, Location where) const {
        if (ground_->derived(fact.variable))
            refuse(where, "a derived predicate cannot be sensed; sense the atoms that it is derived from");
    }

    void mark_uncertain() {
        const FiniteDomainTask& task = *physical_;
        std::vector<bool>& uncertain = task_->uncertain;
        uncertain.assign(task.variable_count(), false);
        for (std::size_t v = 0; v < uncertain.size(); ++v)
            uncertain[v] = task_->initial_values[v] == BeliefTask::kUnknown;
        add_decay();
        for (std::size_t v = 0; v < uncertain.size(); ++v)
            if (task_->lasting[v] != BeliefTask::kForever) uncertain[v] = true;
        for (std::size_t o = 0; o < task.operator_count(); ++o)
            for (std::int32_t variable : task_->forgotten[o])
                uncertain[static_cast<std::size_t>(variable)] = true;
        const auto open = [&](std::span<const Fact> facts) {
            return std::any_of(facts.begin(), facts.end(), [&](const Fact& fact) {
                return uncertain[static_cast<std::size_t>(fact.variable)];
            });
        };
        for (bool changed = true; changed;) {
            changed = false;
            const auto mark = [&](std::int32_t variable) {
                const auto v = static_cast<std::size_t>(variable);
                changed = changed || !uncertain[v];
                uncertain[v] = true;
            };
            for (const GroundEffect& effect : task.effects.items())
                if (effect.condition != 0 && open(task.conditions[effect.condition]))
                    mark(effect.fact.variable);
            for (std::size_t a = 0; a < task.axioms.size(); ++a)
                if (open(task.axiom_bodies[a])) mark(task.axioms[a].head.variable);
        }
        for (std::size_t v = 0; v < uncertain.size(); ++v)
            if (uncertain[v] && !task.derived(static_cast<std::int32_t>(v)) && task.domain_sizes[v] != 2)
                refuse(source_->task->goal.where, "the atoms of " +
                                                      task.fact_name({static_cast<std::int32_t>(v), 0}) +
                                                      " may become uncertain, but exclude each other");
    }

    void add_decay() {
        const FiniteDomainTask& task = *physical_;
        task_->lasting.assign(task.variable_count(), BeliefTask::kForever);
        for (const Decay& decay : source_->decays) {
            const std::string& predicate = source_->task->predicates[decay.predicate.index()].name;
            for (std::size_t v = 0; v < task.variable_count(); ++v) {
                if (task.derived(static_cast<std::int32_t>(v))) continue;
                const auto words = task.fact_names.names[task.first_fact[v]];
                if (!words.empty() && task.fact_names.symbols[words[0]] == predicate)
                    task_->lasting[v] = decay.steps;
            }
        }
    }

    [[noreturn]] void contradiction(Location where) const {
        const Diagnostic diagnostic{Severity::error, where, true,
                                    "no first state satisfies this together with what is certain", ""};
        throw InputError(to_string(diagnostic, *source_->task->sources), {diagnostic});
    }

    void add_initial_clauses() {
        for (const Clause& clause : source_->clauses) add_clause(clause.kind, clause.literals, clause.where);
        for (const MultiValuedVariable& variable : source_->variables)
            if (!variable.observable && variable.values.size() > 1)
                add_clause(ClauseKind::exactly_one, variable.values, variable.where);
    }

    void add_clause(ClauseKind kind, const std::vector<GroundLiteral>& literals, Location where) {
        std::set<Fact> facts;
        std::size_t holding = 0;
        for (const GroundLiteral& literal : literals) {
            const Place found = place(literal);
            if (found.kind == Place::Kind::never) continue;
            const std::int32_t known =
                found.kind == Place::Kind::fact
                    ? task_->initial_values[static_cast<std::size_t>(found.fact.variable)]
                    : found.fact.value;
            if (known == BeliefTask::kUnknown)
                facts.insert(found.fact);
            else
                holding += known == found.fact.value;
        }
        if (kind != ClauseKind::at_most_one) {
            const bool tautology = std::any_of(facts.begin(), facts.end(), [&](const Fact& fact) {
                return facts.contains({fact.variable, 1 - fact.value});
            });
            if (facts.empty() && holding == 0) contradiction(where);
            if (holding == 0 && !tautology) task_->clauses.append(facts);
        }
        if (kind != ClauseKind::at_least_one) {
            if (holding > 1) contradiction(where);
            if (holding == 1) {
                for (const Fact& fact : facts) {
                    task_->clauses.add({fact.variable, 1 - fact.value});
                    task_->clauses.close();
                }
            } else if (facts.size() > 1) {
                task_->groups.append(facts);
            }
        }
    }

    void add_worlds() {
        for (const HiddenWorld& world : source_->hidden) {
            for (const GroundLiteral& literal : world.literals) {
                const Place where = place(literal.predicate, literal.arguments);
                if (where.kind == Place::Kind::fact && !literal.negated) task_->worlds.add(where.fact);
            }
            task_->worlds.close();
        }
    }

    std::shared_ptr<const ContingentTask> source_;
    Augmented augmented_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    std::shared_ptr<AtomIndex> atoms_;
    PlanNames names_;
    std::shared_ptr<BeliefTask> task_;
    std::shared_ptr<const FiniteDomainTask> physical_;
};

/// What is read, but not planned for yet.
void refuse_unsupported(const ContingentTask& task) {
    const auto refuse = [&](Location where, const char* message) {
        grounding::refuse(*task.task, where, message);
    };
    for (const SchemaSensing& schema : task.sensing)
        if (!schema.model.empty()) refuse(schema.model.front().where, "sensing models are not planned for");
    if (!task.default_model.empty())
        refuse(task.default_model.front().where, "sensing models are not planned for");
    if (!task.default_observations.empty())
        refuse(task.default_observations.front().where, "sensing models are not planned for");
}

}  // namespace

GroundBeliefResult ground_belief(std::shared_ptr<const ContingentTask> source, const Budget& budget) {
    refuse_unsupported(*source);
    Augmented augmented = augment(*source);
    GroundOptions options;
    options.prune_irrelevant = false;
    GroundResult ground = praxis::ground(*augmented.task, options, budget);
    GroundBeliefResult result;
    result.stop = ground.stop;
    if (ground.task) result.task = Grounder(std::move(source), std::move(augmented), ground.task)();
    return result;
}

}  // namespace praxis::belief
