#include "tamp/validate/completed_task.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace praxis::tamp {
namespace {

using GroundAtom = std::pair<PredicateId, std::vector<ObjectId>>;

class Completion {
  public:
    Completion(const StreamTask& streams, const RefinedPlan& plan) : streams_(streams), plan_(plan) {
        result_.task = *streams.task;
        for (std::size_t i = 0; i < result_.task.objects.size(); ++i) {
            objects_.emplace(result_.task.objects[i].name, ObjectId(i));
            result_.values.emplace_back();
        }
        for (std::size_t p = 0; p < result_.task.predicates.size(); ++p) {
            const Relation& relation = result_.task.initial_atoms[p];
            for (std::size_t i = 0; i < relation.count; ++i) {
                const auto tuple = relation.tuple(i);
                known_.emplace(PredicateId(p), std::vector<ObjectId>(tuple.begin(), tuple.end()));
            }
        }
        for (Schema& schema : result_.task.schemas) schema.cost.reset();
        result_.task.minimize_cost = false;
    }

    CompletedTask run() {
        for (const StreamFact& fact : plan_.facts) add_outputs(fact);
        add_facts();
        for (const RefinedStep& step : plan_.steps) add_step(step);
        return std::move(result_);
    }

  private:
    ObjectId find(const Value& value, const std::string& user) {
        const auto found = objects_.find(value.name());
        if (found == objects_.end())
            throw IncompletePlan(user + " uses '" + value.name() + "', which no stream has made");
        Value& kept = result_.values[found->second.index()];
        if (!kept.has_content()) kept = value;
        if (!(kept == value)) throw IncompletePlan("'" + value.name() + "' stands for two values");
        return found->second;
    }

    void add_outputs(const StreamFact& fact) {
        if (fact.stream.index() >= streams_.streams.size())
            throw IncompletePlan("there is no stream number " + std::to_string(fact.stream.index()));
        const StreamSchema& schema = streams_.streams[fact.stream.index()];
        if (fact.inputs.size() != schema.input_count() || fact.outputs.size() != schema.output_count())
            throw IncompletePlan("stream '" + schema.name + "' has other inputs and outputs");
        for (std::size_t i = 0; i < fact.outputs.size(); ++i) {
            const std::string& name = fact.outputs[i].name();
            const ObjectId id(result_.task.objects.size());
            if (!objects_.emplace(name, id).second) throw IncompletePlan("'" + name + "' was made twice");
            result_.task.objects.push_back(
                {name, schema.scope.variable_types[schema.input_count() + i], schema.where});
            result_.values.push_back(fact.outputs[i]);
            for (Type& type : result_.task.types) type.contains.push_back(false);
            for (const TypeId type : schema.output_types[i]) {
                Type& owner = result_.task.types[type.index()];
                owner.contains[id.index()] = true;
                owner.objects.push_back(id);
            }
        }
    }

    static GroundAtom bind(const LiftedAtom& atom, const std::vector<ObjectId>& arguments) {
        GroundAtom result{atom.predicate, {}};
        for (const Term term : atom.terms)
            result.second.push_back(term.is_variable() ? arguments[term.variable_index()] : term.object_id());
        return result;
    }

    /// A stream has said something only where its domain holds: in the task, or by what came before.
    void add_facts() {
        struct Pending {
            const StreamSchema* schema;
            std::vector<ObjectId> arguments;
        };
        std::vector<Pending> pending;
        for (const StreamFact& fact : plan_.facts) {
            const StreamSchema& schema = streams_.streams[fact.stream.index()];
            Pending& next = pending.emplace_back(Pending{&schema, {}});
            for (const std::vector<Value>* values : {&fact.inputs, &fact.outputs})
                for (const Value& value : *values)
                    next.arguments.push_back(find(value, "stream '" + schema.name + "'"));
        }
        while (!pending.empty()) {
            const auto ready = [&](const Pending& fact) {
                const bool holds = std::ranges::all_of(fact.schema->domain, [&](const LiftedAtom& atom) {
                    return known_.contains(bind(atom, fact.arguments));
                });
                if (!holds) return false;
                check_types(*fact.schema, fact.arguments);
                for (const LiftedAtom& atom : fact.schema->certified) certify(bind(atom, fact.arguments));
                return true;
            };
            if (std::erase_if(pending, ready) == 0)
                throw IncompletePlan("the domain of stream '" + pending.front().schema->name +
                                     "' does not hold where it is used");
        }
    }

    void check_types(const StreamSchema& schema, const std::vector<ObjectId>& arguments) const {
        for (std::size_t i = 0; i < schema.input_count(); ++i) {
            const Type& type = result_.task.types[schema.scope.variable_types[i].index()];
            if (!type.contains[arguments[i].index()])
                throw IncompletePlan("stream '" + schema.name + "' is used with '" +
                                     result_.task.objects[arguments[i].index()].name + "', which is no " +
                                     type.name);
        }
    }

    void certify(GroundAtom atom) {
        if (!known_.insert(atom).second) return;
        Relation& relation = result_.task.initial_atoms[atom.first.index()];
        relation.arguments.insert(relation.arguments.end(), atom.second.begin(), atom.second.end());
        ++relation.count;
        result_.certified.push_back(std::move(atom));
    }

    void add_step(const RefinedStep& step) {
        const auto schema = std::ranges::find(result_.task.schemas, step.name, &Schema::name);
        if (schema == result_.task.schemas.end())
            throw IncompletePlan("there is no action '" + step.name + "'");
        PlanStep& next = result_.plan.steps.emplace_back();
        next.schema = SchemaId(static_cast<std::size_t>(schema - result_.task.schemas.begin()));
        for (const Value& value : step.arguments)
            next.arguments.push_back(find(value, "action '" + step.name + "'"));
    }

    const StreamTask& streams_;
    const RefinedPlan& plan_;
    CompletedTask result_;
    std::map<std::string, ObjectId, std::less<>> objects_;
    std::set<GroundAtom> known_;
};

}  // namespace

CompletedTask complete(const StreamTask& streams, const RefinedPlan& plan) {
    return Completion(streams, plan).run();
}

}  // namespace praxis::tamp
