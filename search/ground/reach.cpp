#include "search/ground/reach.hpp"

#include <algorithm>
#include <utility>

#include "search/ground/join.hpp"
#include "search/ground/predicate_order.hpp"
#include "search/ground/rules.hpp"

namespace praxis::grounding {

namespace {

/// The action adds the same atom unconditionally, and adds win.
bool added_anyway(const Schema& schema, const Effect& deletion) {
    return std::any_of(schema.effects.begin(), schema.effects.end(), [&](const Effect& effect) {
        return effect.add && effect.predicate == deletion.predicate && effect.terms == deletion.terms &&
               effect.variables == deletion.variables && effect.condition.kind == Connective::truth;
    });
}

}  // namespace

NormalTask normalise(const LiftedTask& task) {
    NormalTask normal;
    normal.lifted = &task;
    for (const Schema& schema : task.schemas) {
        NormalSchema& made = normal.schemas.emplace_back();
        made.precondition = normalise(schema.precondition);
        for (const Effect& effect : schema.effects) {
            if (!effect.add && added_anyway(schema, effect)) continue;
            Condition condition = normalise(effect.condition);
            if (condition.kind != Condition::Kind::falsity)
                made.effects.push_back({&effect, std::move(condition)});
        }
    }
    for (const Axiom& axiom : task.axioms) normal.axioms.push_back(normalise(axiom.body));
    normal.goal = normalise(task.goal);
    return normal;
}

namespace {

/// A head that comes with each new tuple of a relation: an unconditional add effect.
struct Consequence {
    RelationId head;
    std::vector<Term> terms;
};

class Engine {
  public:
    Engine(Relations& relations, const std::vector<Rule>& rules,
           const std::vector<std::vector<Consequence>>& consequences)
        : relations_(relations), rules_(rules), consequences_(consequences) {}

    /// Derives everything that the rules from `first` on derive. False: the budget ran out.
    bool run(std::size_t first);
    std::size_t derivations() const { return derivations_; }

  private:
    struct Trigger {
        std::size_t rule;
        std::size_t atom;
        JoinPlan plan;
    };

    void find_dynamic(std::size_t first);
    bool fire_static_rules(std::size_t first);
    void make_plans();
    JoinPlan plan(const Rule& rule, std::optional<std::size_t> trigger);
    bool process(RelationId relation, Row row);
    void derive(const Rule& rule);

    Relations& relations_;
    const std::vector<Rule>& rules_;
    const std::vector<std::vector<Consequence>>& consequences_;
    std::vector<bool> dynamic_;
    std::vector<RelationId> queue_relations_;     ///< dynamic relations, each with unpublished rows or not
    std::vector<std::vector<Trigger>> triggers_;  ///< by relation
    std::vector<Object> binding_;
    std::vector<Object> tuple_;
    std::vector<Object> consequence_tuple_;
    std::size_t derivations_ = 0;
    std::size_t processed_ = 0;
    std::size_t next_planning_ = 0;
};

bool Engine::run(std::size_t first) {
    find_dynamic(first);
    if (!fire_static_rules(first)) return false;
    processed_ = 0;
    next_planning_ = 0;
    for (bool progress = true; std::exchange(progress, false);) {
        for (RelationId relation : queue_relations_) {
            TupleStore& store = relations_[relation];
            while (store.published() < store.size()) {
                if (processed_ == next_planning_) {
                    make_plans();
                    next_planning_ = std::max<std::size_t>(256, processed_ * 4);
                }
                ++processed_;
                progress = true;
                if (!process(relation, store.published())) return false;
            }
        }
    }
    return true;
}

void Engine::find_dynamic(std::size_t first) {
    dynamic_.assign(relations_.size(), false);
    triggers_.assign(relations_.size(), {});
    queue_relations_.clear();
    std::vector<bool> headed(relations_.size(), false);
    std::vector<bool> used(relations_.size(), false);
    std::size_t most_variables = 1;
    std::size_t widest = 1;
    for (std::size_t r = first; r < rules_.size(); ++r) {
        headed[rules_[r].head] = true;
        for (const Consequence& consequence : consequences_[rules_[r].head]) {
            headed[consequence.head] = true;
            widest = std::max(widest, consequence.terms.size());
        }
        for (const BodyAtom& atom : rules_[r].body.atoms) used[atom.relation] = true;
        most_variables = std::max(most_variables, rules_[r].variable_types->size());
        widest = std::max(widest, rules_[r].head_terms.size());
    }
    binding_.resize(most_variables);
    tuple_.resize(widest);
    consequence_tuple_.resize(widest);
    for (RelationId relation = 0; relation < relations_.size(); ++relation) {
        dynamic_[relation] = headed[relation] && used[relation];
        if (dynamic_[relation]) queue_relations_.push_back(relation);
        // What these rules do not read may be dynamic for later ones, and then must not be published yet.
        if (!headed[relation] && used[relation]) relations_[relation].publish(relations_[relation].size());
    }
    for (std::size_t r = first; r < rules_.size(); ++r) {
        const auto& atoms = rules_[r].body.atoms;
        for (std::size_t a = 0; a < atoms.size(); ++a)
            if (!atoms[a].negated && dynamic_[atoms[a].relation])
                triggers_[atoms[a].relation].push_back({r, a, {}});
    }
}

JoinPlan Engine::plan(const Rule& rule, std::optional<std::size_t> trigger) {
    JoinPlan::Start start;
    start.bound.assign(rule.variable_types->size(), false);
    start.needed.assign(rule.variable_types->size(), false);
    for (Term term : rule.head_terms)
        if (term.is_variable()) start.needed[term.variable_index()] = true;
    start.trigger = trigger;
    return JoinPlan(relations_, rule.body, *rule.variable_types, start);
}

bool Engine::fire_static_rules(std::size_t first) {
    for (std::size_t r = first; r < rules_.size(); ++r) {
        const Rule& rule = rules_[r];
        if (std::any_of(rule.body.atoms.begin(), rule.body.atoms.end(),
                        [&](const BodyAtom& atom) { return !atom.negated && dynamic_[atom.relation]; }))
            continue;
        const JoinPlan plan = this->plan(rule, std::nullopt);
        const bool whole = plan.run(relations_, binding_.data(), kNoRow, [&] {
            derive(rule);
            return relations_.tick();
        });
        if (!whole) return false;
    }
    return true;
}

void Engine::make_plans() {
    for (RelationId relation : queue_relations_)
        for (Trigger& trigger : triggers_[relation]) trigger.plan = plan(rules_[trigger.rule], trigger.atom);
}

bool Engine::process(RelationId relation, Row row) {
    relations_[relation].publish(row + 1);
    for (const Trigger& trigger : triggers_[relation]) {
        const Rule& rule = rules_[trigger.rule];
        const bool whole = trigger.plan.run(relations_, binding_.data(), row, [&] {
            derive(rule);
            return relations_.tick();
        });
        if (!whole) return false;
    }
    return true;
}

void Engine::derive(const Rule& rule) {
    ++derivations_;
    for (std::size_t c = 0; c < rule.head_terms.size(); ++c) {
        const Term term = rule.head_terms[c];
        tuple_[c] = term.is_variable() ? binding_[term.variable_index()] : term.object_id().index();
    }
    if (rule.distinct)
        relations_[rule.head].append(tuple_.data());
    else if (!relations_[rule.head].insert(tuple_.data()).second)
        return;
    for (const Consequence& consequence : consequences_[rule.head]) {
        for (std::size_t c = 0; c < consequence.terms.size(); ++c) {
            const Term term = consequence.terms[c];
            consequence_tuple_[c] =
                term.is_variable() ? tuple_[term.variable_index()] : term.object_id().index();
        }
        relations_[consequence.head].insert(consequence_tuple_.data());
    }
}

/// Makes the program of a task, stratum by stratum, and runs it.
class Reachability {
  public:
    Reachability(const NormalTask& task, Relations& relations)
        : task_(task), lifted_(*task.lifted), relations_(relations) {}

    Reached run() {
        classify();
        bool complete = true;
        for (const std::vector<PredicateId>& component : predicate_order(lifted_)) {
            if (!complete) break;
            complete = add_exact(component);
        }
        if (complete) {
            const std::size_t first = rules_.size();
            for (std::size_t a = 0; a < lifted_.axioms.size(); ++a)
                if (!reached_.exact[lifted_.axioms[a].predicate.index()]) add_axiom(a);
            for (std::size_t s = 0; s < lifted_.schemas.size(); ++s) add_schema(s);
            complete = evaluate(first);
        }
        reached_.complete = complete;
        for (RelationId id = 0; id < relations_.size(); ++id) relations_[id].publish(relations_[id].size());
        return std::move(reached_);
    }

  private:
    void classify() {
        for (const Predicate& predicate : lifted_.predicates)
            reached_.exact.push_back(!predicate.fluent && !predicate.derived);
    }

    bool evaluate(std::size_t first) {
        consequences_.resize(relations_.size());
        Engine engine(relations_, rules_, consequences_);
        const bool complete = engine.run(first);
        reached_.derivations += engine.derivations();
        return complete;
    }

    /// If the component's predicates depend on exact ones only: evaluates them, and they are exact too.
    bool add_exact(const std::vector<PredicateId>& component) {
        const auto inside = [&](PredicateId predicate) {
            return std::find(component.begin(), component.end(), predicate) != component.end();
        };
        for (PredicateId predicate : component)
            if (!lifted_.predicates[predicate.index()].derived) return true;
        std::vector<std::size_t> axioms;
        for (std::size_t a = 0; a < lifted_.axioms.size(); ++a) {
            if (!inside(lifted_.axioms[a].predicate)) continue;
            axioms.push_back(a);
            if (!depends_on_exact(task_.axioms[a], inside)) return true;
        }
        const std::size_t first = rules_.size();
        maker_.start_exact();
        for (std::size_t a : axioms) add_axiom(a);
        if (maker_.relaxed()) {
            rules_.resize(first);
            return true;
        }
        const bool complete = evaluate(first);
        for (PredicateId predicate : component) reached_.exact[predicate.index()] = true;
        return complete;
    }

    template <class Inside>
    bool depends_on_exact(const Condition& condition, const Inside& inside) const {
        if (condition.kind == Condition::Kind::literal && !reached_.exact[condition.predicate.index()] &&
            (condition.negated || !inside(condition.predicate)))
            return false;
        return std::all_of(condition.children.begin(), condition.children.end(),
                           [&](const Condition& child) { return depends_on_exact(child, inside); });
    }

    void add_axiom(std::size_t number) {
        const Axiom& axiom = lifted_.axioms[number];
        std::vector<Term> head;
        for (std::uint32_t i = 0; i < axiom.scope.parameter_count; ++i) head.push_back(Term::variable(i));
        check_columns(axiom.predicate.index(), head, axiom.scope.variable_types);
        for (Body& body : maker_.alternatives(task_.axioms[number], axiom.scope.variable_types)) {
            Rule rule;
            rule.head = axiom.predicate.index();
            rule.head_terms = head;
            rule.body = std::move(body);
            rule.variable_types = &axiom.scope.variable_types;
            rules_.push_back(std::move(rule));
        }
    }

    void add_schema(std::size_t number) {
        const Schema& schema = lifted_.schemas[number];
        const auto& types = schema.scope.variable_types;
        std::vector<Body> bodies = maker_.alternatives(task_.schemas[number].precondition, types);
        // Rules of effects with conditions or variables look the action up.
        const auto& effects = task_.schemas[number].effects;
        const bool looked_up = std::any_of(effects.begin(), effects.end(), [](const NormalEffect& effect) {
            return effect.effect->add &&
                   (effect.condition.kind != Condition::Kind::truth || !effect.effect->variables.empty());
        });
        const bool distinct = bodies.size() == 1 && !looked_up;
        std::vector<Term> parameters;
        std::vector<TypeId> parameter_types;
        for (std::uint32_t i = 0; i < schema.scope.parameter_count; ++i) {
            parameters.push_back(Term::variable(i));
            parameter_types.push_back(types[i]);
        }
        const RelationId relation = relations_.add(parameter_types, !distinct);
        reached_.actions.push_back(relation);
        for (Body& body : bodies) {
            Rule rule;
            rule.head = relation;
            rule.head_terms = parameters;
            rule.body = std::move(body);
            rule.variable_types = &types;
            rule.distinct = distinct;
            rules_.push_back(std::move(rule));
        }
        for (const NormalEffect& effect : effects)
            if (effect.effect->add) add_effect(effect, relation, parameters, types);
    }

    void add_effect(const NormalEffect& effect, RelationId action, const std::vector<Term>& parameters,
                    const std::vector<TypeId>& types) {
        const RelationId head = effect.effect->predicate.index();
        check_columns(head, effect.effect->terms, types);
        for (Body& body : maker_.alternatives(effect.condition, types)) {
            if (body.empty() && effect.effect->variables.empty()) {
                consequences_.resize(relations_.size());
                consequences_[action].push_back({head, effect.effect->terms});
                return;
            }
            Rule rule;
            rule.head = head;
            rule.head_terms = effect.effect->terms;
            rule.body.atoms.push_back({action, parameters, false});
            rule.body.add(body);
            rule.variable_types = &types;
            rules_.push_back(std::move(rule));
        }
    }

    /// Heads whose terms may lie outside the declared types make the column distrusted.
    void check_columns(RelationId relation, const std::vector<Term>& terms,
                       const std::vector<TypeId>& types) {
        const auto& declared = lifted_.predicates[relation].parameters;
        for (std::size_t c = 0; c < terms.size(); ++c) {
            const bool fits =
                terms[c].is_variable()
                    ? relations_.within(types[terms[c].variable_index()], declared[c])
                    : bool{lifted_.types[declared[c].index()].contains[terms[c].object_id().index()]};
            if (!fits) relations_.distrust(relation, c);
        }
    }

    const NormalTask& task_;
    const LiftedTask& lifted_;
    Relations& relations_;
    Reached reached_;
    std::vector<Rule> rules_;
    std::vector<std::vector<Consequence>> consequences_;
    RuleMaker maker_{relations_, reached_.exact, rules_};
};

}  // namespace

Reached reach(const NormalTask& task, Relations& relations) {
    return Reachability(task, relations).run();
}

}  // namespace praxis::grounding
