#include "belief/augment.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "belief/ground/observables.hpp"
#include "search/ground/refuse.hpp"

namespace praxis::belief {
namespace {

constexpr std::size_t kMostUncertain = 2'000'000;

bool mentions(const Formula& formula, const std::vector<bool>& predicates) {
    if (formula.kind == Connective::atom) return predicates[formula.predicate.index()];
    return std::any_of(formula.children.begin(), formula.children.end(),
                       [&](const Formula& child) { return mentions(child, predicates); });
}

class Augmenter {
  public:
    explicit Augmenter(const ContingentTask& source)
        : source_(source), task_(std::make_shared<LiftedTask>(*source.task)) {
        seen_.resize(task_->predicates.size());
        forgotten_.assign(task_->predicates.size(), false);
        for (const SchemaSensing& sensing : source_.sensing)
            for (const Effect& effect : sensing.forgotten) forgotten_[effect.predicate.index()] = true;
        for (const Decay& decay : source.decays) forgotten_[decay.predicate.index()] = true;
        result_.uncertain.resize(task_->predicates.size());
        for (std::size_t p = 0; p < task_->predicates.size(); ++p)
            result_.uncertain[p].arity = static_cast<std::uint32_t>(task_->predicates[p].parameters.size());
    }

    Augmented operator()() {
        result_.schemas = task_->schemas.size();
        collect_uncertain();
        const std::vector<bool> open = uncertain_predicates();
        sense_ = declare("@sense", {}, true);
        for (std::size_t s = 0; s < result_.schemas; ++s)
            if (senses(s) || task_->schemas[s].effects.empty())
                task_->schemas[s].effects.push_back(effect(sense_, {}, true));
        for (std::size_t p = 0; p < open.size(); ++p)
            if (open[p]) add_changes(p);
        result_.first_sensor = task_->schemas.size();
        for (const Sensor& sensor : source_.sensors) {
            Schema schema;
            schema.name = "@" + sensor.name;
            schema.scope = sensor.scope;
            schema.precondition = sensor.condition;
            schema.effects.push_back(effect(sense_, {}, true));
            schema.where = sensor.where;
            task_->schemas.push_back(std::move(schema));
        }
        result_.task = std::move(task_);
        return std::move(result_);
    }

  private:
    bool senses(std::size_t schema) const {
        const SchemaSensing& sensing = source_.sensing[schema];
        if (sensing.own_model || !sensing.observations.empty()) return true;
        return !source_.default_model.empty() || !source_.default_observations.empty();
    }

    void collect_uncertain() {
        for (std::size_t p = 0; p < task_->predicates.size(); ++p) {
            const Relation& known = task_->initial_atoms[p];
            for (std::size_t i = 0; i < known.count; ++i)
                seen_[p].insert({known.tuple(i).begin(), known.tuple(i).end()});
        }
        for (const GroundLiteral& literal : source_.known_false) {
            seen_[literal.predicate.index()].insert(literal.arguments);
            known_false_.emplace(literal.predicate, literal.arguments);
        }
        std::vector<const MultiValuedVariable*> open;
        for (const MultiValuedVariable& variable : source_.variables)
            if (!variable.observable && !decided(variable)) open.push_back(&variable);
        for (const GroundLiteral& literal : source_.unknown)
            add(literal.predicate.index(), literal.arguments);
        for (const Clause& clause : source_.clauses)
            for (const GroundLiteral& literal : clause.literals)
                add(literal.predicate.index(), literal.arguments);
        for (const MultiValuedVariable* variable : open) add_values(*variable);
        const std::vector<bool> asked = find_observables(source_).asked;
        for (std::size_t p = 0; p < task_->predicates.size(); ++p)
            if (source_.open_world[p] || asked[p]) add_all(p);
    }

    /// One of the values is certainly true, or the only one certainly false.
    bool decided(const MultiValuedVariable& variable) const {
        const auto seen = [&](const GroundLiteral& value) {
            return seen_[value.predicate.index()].contains(value.arguments);
        };
        if (variable.values.size() == 1) return seen(variable.values.front());
        return std::any_of(variable.values.begin(), variable.values.end(), [&](const GroundLiteral& value) {
            return seen(value) && !known_false_.contains({value.predicate, value.arguments});
        });
    }
    void add_values(const MultiValuedVariable& variable) {
        for (const GroundLiteral& value : variable.values) add(value.predicate.index(), value.arguments);
    }

    void add(std::size_t predicate, const std::vector<ObjectId>& arguments) {
        if (!seen_[predicate].insert(arguments).second) return;
        for (Relation* relation : {&result_.uncertain[predicate], &task_->initial_atoms[predicate]}) {
            relation->arguments.insert(relation->arguments.end(), arguments.begin(), arguments.end());
            ++relation->count;
        }
        if (++count_ > kMostUncertain) refuse_too_many(task_->predicates[predicate]);
    }

    void add_all(std::size_t predicate) {
        std::vector<ObjectId> arguments;
        for_each_tuple(task_->predicates[predicate], arguments, [&] { add(predicate, arguments); });
    }
    template <class Visit>
    void for_each_tuple(const Predicate& predicate, std::vector<ObjectId>& arguments,
                        const Visit& visit) const {
        if (arguments.size() == predicate.parameters.size()) return visit();
        for (ObjectId object : task_->types[predicate.parameters[arguments.size()].index()].objects) {
            arguments.push_back(object);
            for_each_tuple(predicate, arguments, visit);
            arguments.pop_back();
        }
    }

    Relation all_tuples(const Predicate& predicate) const {
        Relation result;
        result.arity = static_cast<std::uint32_t>(predicate.parameters.size());
        std::vector<ObjectId> arguments;
        for_each_tuple(predicate, arguments, [&] {
            result.arguments.insert(result.arguments.end(), arguments.begin(), arguments.end());
            if (++result.count > kMostUncertain) refuse_too_many(predicate);
        });
        return result;
    }

    [[noreturn]] void refuse_too_many(const Predicate& predicate) const {
        grounding::refuse(*source_.task, predicate.where, "more than two million uncertain atoms");
    }

    /// Predicates of which some atom may be uncertain at some time.
    std::vector<bool> uncertain_predicates() const {
        std::vector<bool> open(task_->predicates.size(), false);
        for (std::size_t p = 0; p < open.size(); ++p) open[p] = result_.uncertain[p].count > 0;
        for (std::size_t p = 0; p < open.size(); ++p) open[p] = open[p] || forgotten_[p];
        for (bool changed = true; changed;) {
            changed = false;
            const auto mark = [&](PredicateId predicate) {
                if (open[predicate.index()]) return;
                open[predicate.index()] = true;
                changed = true;
            };
            for (const Schema& schema : task_->schemas)
                for (const Effect& effect : schema.effects)
                    if (mentions(effect.condition, open)) mark(effect.predicate);
            for (const Axiom& axiom : task_->axioms)
                if (mentions(axiom.body, open)) mark(axiom.predicate);
        }
        for (std::size_t p = 0; p < open.size(); ++p)
            if (task_->predicates[p].derived) open[p] = false;
        return open;
    }

    PredicateId declare(std::string name, std::vector<TypeId> parameters, bool fluent) {
        Predicate predicate;
        predicate.name = std::move(name);
        predicate.parameters = std::move(parameters);
        predicate.fluent = fluent;
        Relation atoms;
        atoms.arity = static_cast<std::uint32_t>(predicate.parameters.size());
        task_->predicates.push_back(std::move(predicate));
        task_->initial_atoms.push_back(std::move(atoms));
        return PredicateId(task_->predicates.size() - 1);
    }

    static Effect effect(PredicateId predicate, std::vector<Term> terms, bool add) {
        Effect result;
        result.add = add;
        result.predicate = predicate;
        result.terms = std::move(terms);
        return result;
    }

    /// The schemas that change atoms of the predicate, for the atoms that are uncertain at first; one atom is
    /// enough where there is none.
    void add_changes(std::size_t p) {
        const Predicate predicate = task_->predicates[p];
        task_->predicates[p].fluent = true;
        const PredicateId open = declare("@open-" + predicate.name, predicate.parameters, false);
        Relation& atoms = task_->initial_atoms[open.index()];
        atoms = forgotten_[p] ? all_tuples(predicate) : result_.uncertain[p];
        if (atoms.count == 0 && !first_tuple(predicate, atoms)) return;
        for (const bool add : {true, false}) {
            Schema schema;
            schema.name = (add ? "@set-" : "@clear-") + predicate.name;
            std::vector<Term> terms;
            for (std::size_t i = 0; i < predicate.parameters.size(); ++i) {
                schema.scope.variable_types.push_back(predicate.parameters[i]);
                schema.scope.variable_names.push_back("?x" + std::to_string(i));
                terms.push_back(Term::variable(i));
            }
            schema.scope.parameter_count = static_cast<std::uint32_t>(terms.size());
            schema.precondition.kind = Connective::atom;
            schema.precondition.predicate = open;
            schema.precondition.terms = terms;
            schema.effects.push_back(effect(PredicateId(p), terms, add));
            schema.effects.push_back(effect(sense_, {}, true));
            task_->schemas.push_back(std::move(schema));
        }
    }

    bool first_tuple(const Predicate& predicate, Relation& atoms) const {
        for (TypeId type : predicate.parameters) {
            if (task_->types[type.index()].objects.empty()) return false;
            atoms.arguments.push_back(task_->types[type.index()].objects.front());
        }
        atoms.count = 1;
        return true;
    }

    const ContingentTask& source_;
    std::shared_ptr<LiftedTask> task_;
    Augmented result_;
    std::vector<std::set<std::vector<ObjectId>>> seen_;  ///< by predicate: atoms that have been looked at
    std::set<std::pair<PredicateId, std::vector<ObjectId>>> known_false_;
    std::vector<bool> forgotten_;  ///< by predicate: its atoms may be forgotten
    PredicateId sense_;
    std::size_t count_ = 0;
};

}  // namespace

Augmented augment(const ContingentTask& source) {
    return Augmenter(source)();
}

}  // namespace praxis::belief
