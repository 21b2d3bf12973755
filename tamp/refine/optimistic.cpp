#include "tamp/refine/optimistic.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "search/validate/condition.hpp"
#include "search/validate/evaluator.hpp"
#include "search/validate/fact_table.hpp"

namespace praxis::tamp {
namespace {

using validation::Condition;
using validation::Evaluator;
using validation::FactTable;

/// Samples of one instance that are enumerated; a stream with more is taken to have no end.
constexpr std::uint32_t kMostSamples = 1024;
/// Steps of a cost in the symbolic task.
constexpr double kCostUnit = 1000;

class NoAction : public ActionText {
  public:
    std::string text() const override { return ""; }
};

Condition conjunction(const std::vector<LiftedAtom>& atoms) {
    Formula all;
    all.kind = Connective::conjunction;
    for (const LiftedAtom& atom : atoms) {
        Formula& child = all.children.emplace_back();
        child.kind = Connective::atom;
        child.predicate = atom.predicate;
        child.terms = atom.terms;
    }
    return validation::compile(all);
}

class Instantiator {
  public:
    Instantiator(const StreamTask& streams, Samples& samples, const Instantiation& options,
                 const Budget& budget)
        : streams_(streams),
          samples_(samples),
          options_(options),
          budget_(budget),
          task_(std::make_shared<LiftedTask>(*streams.task)) {
        for (std::size_t p = 0; p < task_->predicates.size(); ++p) {
            const Relation& relation = task_->initial_atoms[p];
            FactTable& table = tables_.emplace_back(relation.arity);
            Tuple tuple(relation.arity + std::size_t{1});
            for (std::size_t i = 0; i < relation.count; ++i) {
                std::ranges::transform(relation.tuple(i), tuple.begin(), &ObjectId::index);
                table.insert(tuple.data());
            }
        }
        for (std::size_t i = 0; i < task_->objects.size(); ++i) {
            made_.producer.push_back(OptimisticTask::kNone);
            made_.value.push_back(static_cast<ValueNumber>(i));
        }
        for (const StreamSchema& stream : streams.streams) domains_.push_back(conjunction(stream.domain));
    }

    OptimisticTask run() {
        Evaluator evaluator(*task_, tables_);
        bool more = true;
        for (std::uint32_t level = 0; more && level < options_.max_level && going(); ++level) {
            more = false;
            for (std::size_t stream = 0; stream < streams_.streams.size() && going(); ++stream)
                if (instantiate(evaluator, StreamId(stream))) more = true;
            for (const auto& [predicate, tuple] : certified_) insert(predicate, tuple);
            certified_.clear();
        }
        if (more || !going()) made_.complete = false;
        for (std::size_t i = 0; i < streams_.functions.size() && going(); ++i) evaluate(evaluator, i);
        made_.task = std::move(task_);
        return std::move(made_);
    }

  private:
    bool going() {
        if (!made_.materialised || budget_.exhausted() != Stop::none ||
            made_.instances.size() >= options_.max_instances) {
            made_.complete = false;
            return false;
        }
        return true;
    }

    void insert(PredicateId predicate, const Tuple& tuple) {
        if (!tables_[predicate.index()].insert(tuple.data())) return;
        Relation& relation = task_->initial_atoms[predicate.index()];
        for (std::uint32_t i = 0; i < relation.arity; ++i) relation.arguments.emplace_back(tuple[i]);
        ++relation.count;
    }

    /// All bindings of a scope's parameters for which the condition holds, one after the other.
    std::vector<std::uint32_t> bindings(Evaluator& evaluator, const Scope& scope, const Condition& domain) {
        std::vector<std::uint32_t> wanted(scope.parameter_count);
        for (std::uint32_t i = 0; i < wanted.size(); ++i) wanted[i] = i;
        std::vector<std::uint32_t> result;
        evaluator.enter(scope);
        if (!evaluator.inhabited(wanted)) return result;
        const Condition* condition = &domain;
        evaluator.enumerate({&condition, 1}, wanted, [&] {
            for (const std::uint32_t variable : wanted) result.push_back(evaluator.value(variable));
            return result.size() / (wanted.size() + 1) > options_.max_instances;
        });
        return result;
    }

    bool instantiate(Evaluator& evaluator, StreamId id) {
        const StreamSchema& stream = streams_.streams[id.index()];
        const std::size_t size = stream.input_count();
        bool any = false;
        if (size == 0) {
            evaluator.enter(stream.scope);
            return evaluator.holds(domains_[id.index()]) && make(id, {});
        }
        const std::vector<std::uint32_t> all = bindings(evaluator, stream.scope, domains_[id.index()]);
        for (std::size_t begin = 0; begin + size <= all.size() && going(); begin += size)
            any = make(id, std::span<const std::uint32_t>(all).subspan(begin, size)) || any;
        return any;
    }

    bool make(StreamId id, std::span<const std::uint32_t> inputs) {
        Tuple key{id.index()};
        key.insert(key.end(), inputs.begin(), inputs.end());
        if (!seen_.try_emplace(std::move(key), 0).second) return false;
        const StreamSchema& stream = streams_.streams[id.index()];
        const StreamInfo& info = samples_.info(id);
        if (stream.fluents.empty() && info.effort <= options_.materialise_effort) {
            std::vector<ValueNumber> values;
            for (const std::uint32_t input : inputs) values.push_back(made_.value[input]);
            if (std::ranges::find(values, OptimisticTask::kNone) == values.end())
                return materialise(id, inputs, values);
        }
        const bool single = stream.output_count() == 0 || info.max_samples == 1;
        for (std::uint32_t copy = 0; copy < (single ? 1 : options_.copies); ++copy) {
            StreamInstance& instance = made_.instances.emplace_back();
            instance.stream = id;
            for (const std::uint32_t input : inputs) instance.inputs.emplace_back(input);
            for (std::size_t i = 0; i < stream.output_count(); ++i)
                instance.outputs.push_back(add_object(stream, i, OptimisticTask::kNone));
            certify(stream, instance.inputs, instance.outputs, true);
        }
        return true;
    }

    bool materialise(StreamId id, std::span<const std::uint32_t> inputs,
                     const std::vector<ValueNumber>& values) {
        const StreamSchema& stream = streams_.streams[id.index()];
        SampleList& list = samples_.list(id, values, {});
        while (!list.finished && list.count < kMostSamples && budget_.exhausted() == Stop::none)
            samples_.extend(list, id, values, {}, NoAction());
        const std::size_t size = stream.output_count();
        values_made_ += list.outputs.size();
        if (!list.finished || !list.definite || values_made_ > options_.max_values)
            made_.materialised = false;
        std::vector<ObjectId> objects;
        for (const std::uint32_t input : inputs) objects.emplace_back(input);
        for (std::uint32_t sample = 0; sample < list.count; ++sample) {
            std::vector<ObjectId> outputs;
            for (std::size_t i = 0; i < size; ++i)
                outputs.push_back(add_object(stream, i, list.outputs[sample * size + i]));
            certify(stream, objects, outputs, false);
        }
        return list.count > 0;
    }

    ObjectId add_object(const StreamSchema& stream, std::size_t output, std::uint32_t value) {
        const ObjectId id(task_->objects.size());
        const bool known = value != OptimisticTask::kNone;
        const std::string& variable = stream.scope.variable_names[stream.input_count() + output];
        Object& object = task_->objects.emplace_back();
        object.name = known ? samples_.value(value).name()
                            : '#' + variable.substr(1) + '-' + std::to_string(id.index());
        object.type = stream.scope.variable_types[stream.input_count() + output];
        object.where = stream.where;
        for (Type& type : task_->types) type.contains.push_back(false);
        for (const TypeId type : stream.output_types[output]) {
            task_->types[type.index()].contains[id.index()] = true;
            task_->types[type.index()].objects.push_back(id);
        }
        made_.value.push_back(value);
        made_.producer.push_back(known ? OptimisticTask::kNone
                                       : static_cast<std::uint32_t>(made_.instances.size() - 1));
        return id;
    }

    void certify(const StreamSchema& stream, std::span<const ObjectId> inputs,
                 std::span<const ObjectId> outputs, bool believed) {
        for (const LiftedAtom& atom : stream.certified) {
            Tuple tuple;
            for (const Term term : atom.terms) {
                if (!term.is_variable())
                    tuple.push_back(term.object_id().index());
                else if (term.variable_index() < inputs.size())
                    tuple.push_back(inputs[term.variable_index()].index());
                else
                    tuple.push_back(outputs[term.variable_index() - inputs.size()].index());
            }
            tuple.reserve(tuple.size() + 1);  // tables want an address, also of a tuple without objects
            Tuple key{atom.predicate.index()};
            key.insert(key.end(), tuple.begin(), tuple.end());
            if (!believed) {
                made_.certified_by.erase(key);
                known_.try_emplace(std::move(key), 0);
            } else if (!tables_[atom.predicate.index()].contains(tuple.data()) && !known_.contains(key)) {
                made_.certified_by.try_emplace(std::move(key),
                                               static_cast<std::uint32_t>(made_.instances.size() - 1));
            }
            certified_.emplace_back(atom.predicate, std::move(tuple));
        }
    }

    void evaluate(Evaluator& evaluator, std::size_t number) {
        const FunctionSchema& function = streams_.functions[number];
        FunctionTable& table = task_->initial_values[function.function.index()];
        TupleMap<std::uint32_t> known;
        for (std::size_t i = 0; i < table.tuples.count; ++i) {
            Tuple tuple;
            for (const ObjectId object : table.tuples.tuple(i)) tuple.push_back(object.index());
            known.emplace(std::move(tuple), 0);
        }
        const Condition domain = conjunction(function.domain);
        const std::size_t size = function.scope.parameter_count;
        std::vector<std::uint32_t> all = bindings(evaluator, function.scope, domain);
        if (size == 0) all.assign(1, 0);
        for (std::size_t begin = 0; begin + size <= all.size(); begin += std::max<std::size_t>(size, 1)) {
            const auto tuple = std::span<const std::uint32_t>(all).subspan(begin, size);
            if (!known.try_emplace(Tuple(tuple.begin(), tuple.end()), 0).second) continue;
            std::vector<ValueNumber> values;
            for (const std::uint32_t object : tuple) values.push_back(made_.value[object]);
            const bool bound = std::ranges::find(values, OptimisticTask::kNone) == values.end();
            const double cost = bound ? samples_.cost(number, values) : samples_.lower_bound(number);
            for (const std::uint32_t object : tuple) table.tuples.arguments.emplace_back(object);
            ++table.tuples.count;
            const double units = std::min(std::round(cost * kCostUnit), 1e9);
            table.values.emplace_back(static_cast<std::int64_t>(units), static_cast<std::int64_t>(kCostUnit));
        }
    }

    const StreamTask& streams_;
    Samples& samples_;
    const Instantiation& options_;
    const Budget& budget_;
    std::shared_ptr<LiftedTask> task_;
    std::vector<FactTable> tables_;
    std::vector<Condition> domains_;                        ///< by stream
    std::vector<std::pair<PredicateId, Tuple>> certified_;  ///< since the tables were last brought up to date
    TupleMap<std::uint8_t> known_;                          ///< atoms that materialised instances certify
    TupleMap<std::uint8_t> seen_;                           ///< instances by stream and inputs
    OptimisticTask made_;
    std::size_t values_made_ = 0;
};

}  // namespace

OptimisticTask instantiate(const StreamTask& task, Samples& samples, const Instantiation& options,
                           const Budget& budget) {
    return Instantiator(task, samples, options, budget).run();
}

}  // namespace praxis::tamp
