#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "belief/augment.hpp"
#include "belief/belief_task.hpp"
#include "belief/ground/choices.hpp"
#include "belief/ground/conditions.hpp"
#include "belief/ground/sensing_models.hpp"
#include "search/ground/ground.hpp"

namespace praxis::belief {
namespace {

class Grounder {
  public:
    Grounder(std::shared_ptr<const ContingentTask> source, Augmented augmented,
             std::shared_ptr<const FiniteDomainTask> ground)
        : source_(std::move(source)),
          augmented_(std::move(augmented)),
          ground_(std::move(ground)),
          conditions_(source_, ground_, std::make_shared<AtomIndex>(*augmented_.task, *ground_)),
          models_(source_, ground_, conditions_),
          names_(*augmented_.task, *ground_),
          task_(std::make_shared<BeliefTask>()) {
        find_choices();
    }

    std::shared_ptr<const BeliefTask> operator()() {
        task_->source = source_;
        task_->lifted = augmented_.task;
        add_initial_values();
        split_operators();
        complete_forgotten();
        models_.begin(*task_, *physical_, !task_->forgotten.items().empty());
        task_->physical = physical_;
        task_->atoms = std::make_shared<AtomIndex>(*augmented_.task, *physical_);
        mark_uncertain();
        if (physical_->proved_unsolvable) return std::move(task_);  // nearly nothing is left to speak of
        add_initial_clauses();
        add_worlds();
        return std::move(task_);
    }

  private:
    void add_initial_values() {
        task_->initial_values = ground_->initial_values;
        for (std::size_t p = 0; p < augmented_.uncertain.size(); ++p) {
            const Relation& relation = augmented_.uncertain[p];
            for (std::size_t i = 0; i < relation.count; ++i) {
                const Place where = conditions_.place(PredicateId(p), relation.tuple(i));
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
                add_sensing(o, step);
            }
        }
        models_.extend(*physical);
        physical_ = std::move(physical);
        add_open_eyes();
    }

    /// `:observable`: atoms that can be read at any time, by sensors without a condition.
    void add_open_eyes() {
        for (std::size_t p = 0; p < source_->declared_observable.size(); ++p) {
            if (!source_->declared_observable[p]) continue;
            const Predicate& predicate = source_->task->predicates[p];
            for (std::size_t v : variables_of(predicate.name)) {
                const Fact fact{static_cast<std::int32_t>(v), 0};
                check_readable(fact, predicate.where);
                if (physical_->domain_sizes[v] != 2) continue;  // never uncertain
                std::string name = physical_->fact_names.words(physical_->fact_number(fact));
                task_->sensors.push_back({"(" + std::move(name) + ")", {fact, 1}});
                task_->sensor_conditions.close();
            }
        }
    }

    /// Those whose first value is about the predicate.
    std::vector<std::size_t> variables_of(const std::string& predicate) const {
        std::vector<std::size_t> result;
        for (std::size_t v = 0; v < physical_->variable_count(); ++v) {
            const auto words = physical_->fact_names.names[physical_->first_fact[v]];
            if (!words.empty() && physical_->fact_names.symbols[words[0]] == predicate) result.push_back(v);
        }
        return result;
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

    /// The multi-valued variables all of whose values may be uncertain.
    void find_choices() {
        choices_of_.resize(ground_->variable_count());
        for (const MultiValuedVariable& variable : source_->variables) {
            if (variable.observable || variable.values.size() < 2) continue;
            Choice choice{&variable, {}, false};
            bool complete = true;
            for (const GroundLiteral& value : variable.values) {
                const Place where = conditions_.place(value.predicate, value.arguments);
                if (where.kind == Place::Kind::fact) choice.facts.push_back(where.fact);
                complete = complete && where.kind != Place::Kind::always &&
                           (where.kind == Place::Kind::never ||
                            ground_->domain_sizes[static_cast<std::size_t>(where.fact.variable)] == 2);
            }
            if (!complete || choice.facts.size() < 2) continue;
            for (const Fact& fact : choice.facts)
                choices_of_[static_cast<std::size_t>(fact.variable)].push_back(choices_.size());
            choices_.push_back(std::move(choice));
        }
    }

    /// Leaving one value open leaves the whole multi-valued variable open.
    std::set<std::int32_t> forgotten_by(const PlanStep& step) {
        std::set<std::int32_t> result;
        const std::size_t s = step.schema.index();
        for (const Effect& effect : source_->sensing[s].forgotten)
            for_each_fact(effect, source_->task->schemas[s].scope, step.arguments, conditions_.open(),
                          [&](Fact fact) {
                              result.insert(fact.variable);
                              for (std::size_t c : choices_of_[static_cast<std::size_t>(fact.variable)]) {
                                  choices_[c].forgotten = true;
                                  for (const Fact& other : choices_[c].facts) result.insert(other.variable);
                              }
                          });
        return result;
    }

    /// What observables show of what is left open is left open, too.
    void complete_forgotten() {
        if (task_->forgotten.items().empty()) return;
        PackedLists<std::int32_t> all;
        for (std::size_t o = 0; o < task_->forgotten.size(); ++o) {
            const auto own = task_->forgotten[o];
            std::set<std::int32_t> variables(own.begin(), own.end());
            variables.merge(models_.depending(variables));
            all.append(variables);
        }
        task_->forgotten = std::move(all);
        for (const Choice& choice : choices_) {
            if (!choice.forgotten) continue;
            if (const auto o = breaks_choice(*physical_, choice.facts))
                conditions_.refuse(choice.variable->where, "an action leaves the variable open, but " +
                                                               physical_->operator_name(*o) +
                                                               " may leave it with no value, or several");
            task_->choices.append(choice.facts);
        }
    }

    /// What is known of the state after an operator whose precondition held and that leaves variables open.
    Context after(std::size_t o, const std::set<std::int32_t>& forgotten) const {
        Context values = conditions_.open();
        for (const Fact& fact : ground_->preconditions[o])
            values[static_cast<std::size_t>(fact.variable)] = fact.value;
        for (const GroundEffect& effect : ground_->effects[o]) {
            std::int32_t& value = values[static_cast<std::size_t>(effect.fact.variable)];
            if (effect.condition == 0)
                value = effect.fact.value;
            else if (value != effect.fact.value)
                value = kOpen;
        }
        for (std::int32_t variable : forgotten) values[static_cast<std::size_t>(variable)] = kOpen;
        return values;
    }

    /// Calls visit(fact) for every atom that something described with variables and a condition speaks of.
    template <class Described, class Visit>
    void for_each_fact(const Described& described, const Scope& scope, const std::vector<ObjectId>& arguments,
                       const Context& known, const Visit& visit) const {
        Conditions::Binding binding = Conditions::bind(scope, arguments);
        conditions_.instances(
            described.variables, described.condition, scope, binding, known,
            [&](const Conditions::Binding& full) {
                if (conditions_.verdict(described.condition, scope, full, known) !=
                    Conditions::Verdict::holds)
                    conditions_.refuse(described.where,
                                       "what is observed depends on a condition that can change");
                const Place where =
                    conditions_.place(described.predicate, Conditions::resolve(described.terms, full));
                if (where.kind == Place::Kind::fact) visit(where.fact);
            });
    }

    void add_sensing(std::size_t o, const PlanStep& step) {
        const std::size_t s = step.schema.index();
        const Scope& scope = source_->task->schemas[s].scope;
        const SchemaSensing& sensing = source_->sensing[s];
        const std::set<std::int32_t> forgotten = forgotten_by(step);
        const Context known = after(o, forgotten);
        const auto read = [&](const std::vector<Observation>& observations, const Scope& variables,
                              const std::vector<ObjectId>& arguments) {
            for (const Observation& observation : observations)
                for_each_fact(observation, variables, arguments, known, [&](Fact fact) {
                    check_readable(fact, observation.where);
                    task_->readings.add({fact, observation.accuracy});
                });
        };
        read(sensing.observations, scope, step.arguments);
        if (!sensing.own_model) read(source_->default_observations, source_->default_scope, {});
        models_.read(s, step.arguments, known, task_->readings);
        task_->readings.close();
        task_->forgotten.append(forgotten);
    }

    void add_sensor(std::size_t o, const PlanStep& step) {
        const Sensor& sensor = source_->sensors[step.schema.index() - augmented_.first_sensor];
        std::string name = "(" + sensor.name;
        for (ObjectId object : step.arguments) name += " " + source_->task->objects[object.index()].name;
        name += ")";
        for (const Observation& observation : sensor.observations)
            for_each_fact(observation, sensor.scope, step.arguments, after(o, {}), [&](Fact fact) {
                check_readable(fact, observation.where);
                task_->sensors.push_back({name, {fact, observation.accuracy}});
                task_->sensor_conditions.append(ground_->preconditions[o]);
            });
    }

    void check_readable(Fact fact, Location where) const {
        if (ground_->derived(fact.variable))
            conditions_.refuse(
                where, "a derived predicate cannot be sensed; sense the atoms that it is derived from");
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
                conditions_.refuse(source_->task->goal.where,
                                   "the atoms of " + task.fact_name({static_cast<std::int32_t>(v), 0}) +
                                       " may become uncertain, but exclude each other");
    }

    void add_decay() {
        const FiniteDomainTask& task = *physical_;
        task_->lasting.assign(task.variable_count(), BeliefTask::kForever);
        for (const Decay& decay : source_->decays) {
            if (source_->sticky[decay.predicate.index()])
                conditions_.refuse(decay.where, "':decay' of a predicate that is ':sticky'");
            for (std::size_t v : variables_of(source_->task->predicates[decay.predicate.index()].name))
                if (!task.derived(static_cast<std::int32_t>(v))) task_->lasting[v] = decay.steps;
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
        add_choices();
    }

    void add_choices() {
        for (std::size_t c = 0; c < task_->choices.size(); ++c) {
            task_->add_clause(task_->choices[c], true);
            task_->add_group(task_->choices[c], true);
        }
    }

    void add_clause(ClauseKind kind, const std::vector<GroundLiteral>& literals, Location where) {
        std::set<Fact> facts;
        std::size_t holding = 0;
        for (const GroundLiteral& literal : literals) {
            const Place found = conditions_.place(literal);
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
            if (holding == 0 && !tautology)
                task_->add_clause(std::vector<Fact>(facts.begin(), facts.end()), false);
        }
        if (kind != ClauseKind::at_least_one) {
            if (holding > 1) contradiction(where);
            if (holding == 1) {
                for (const Fact& fact : facts)
                    task_->add_clause(std::vector<Fact>{{fact.variable, 1 - fact.value}}, false);
            } else if (facts.size() > 1) {
                task_->add_group(std::vector<Fact>(facts.begin(), facts.end()), false);
            }
        }
    }

    void add_worlds() {
        for (const HiddenWorld& world : source_->hidden) {
            for (const GroundLiteral& literal : world.literals) {
                const Place where = conditions_.place(literal.predicate, literal.arguments);
                if (where.kind == Place::Kind::fact && !literal.negated) task_->worlds.add(where.fact);
            }
            task_->worlds.close();
        }
    }

    /// A multi-valued variable by its ground facts.
    struct Choice {
        const MultiValuedVariable* variable;
        std::vector<Fact> facts;
        bool forgotten;  ///< some action leaves it open
    };

    std::shared_ptr<const ContingentTask> source_;
    Augmented augmented_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    Conditions conditions_;
    SensingModels models_;
    PlanNames names_;
    std::vector<Choice> choices_;
    std::vector<std::vector<std::size_t>> choices_of_;  ///< by ground variable
    std::shared_ptr<BeliefTask> task_;
    std::shared_ptr<FiniteDomainTask> physical_;
};

}  // namespace

GroundBeliefResult ground_belief(std::shared_ptr<const ContingentTask> source, const Budget& budget) {
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
