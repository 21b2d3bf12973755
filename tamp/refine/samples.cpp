#include "tamp/refine/samples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parser/suggest.hpp"

namespace praxis::tamp {
namespace {

std::uint64_t hash_text(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) hash = mix(hash, static_cast<unsigned char>(c));
    return hash;
}

}  // namespace

Samples::Samples(const RefinementProblem& problem, const Budget& budget, RefineStatistics& statistics)
    : problem_(problem), budget_(budget), statistics_(statistics) {
    const StreamTask& task = *problem.task;
    for (const StreamSchema& stream : task.streams) {
        streams_.push_back(problem.library->find(stream.name));
        if (streams_.back() != nullptr) continue;
        Suggestion suggestion(stream.name);
        for (const std::string& name : problem.library->stream_names()) suggestion.consider(name);
        throw std::invalid_argument("nothing is bound to stream '" + stream.name + "'" +
                                    (suggestion.found() ? "; " + suggestion.hint() : ""));
    }
    for (const FunctionSchema& function : task.functions) {
        const std::string& name = task.task->functions[function.function.index()].name;
        functions_.push_back(problem.library->find_function(name));
        if (functions_.back() == nullptr)
            throw std::invalid_argument("nothing is bound to function '" + name + "'");
    }
    std::size_t known = 0;
    for (const Object& object : task.task->objects) {
        const auto given = problem.values.find(object.name);
        known += given != problem.values.end() ? 1 : 0;
        values_.push_back((given != problem.values.end() ? given->second : Value()).named(object.name));
        fingerprints_.push_back(hash_text(object.name));
    }
    if (known == problem.values.size()) return;
    for (const auto& [name, value] : problem.values)
        if (std::ranges::find(task.task->objects, name, &Object::name) == task.task->objects.end())
            throw std::invalid_argument("a value for '" + name + "', which is no object of the problem");
}

SampleList& Samples::list(StreamId stream, std::span<const ValueNumber> inputs,
                          std::span<const ValueAtom> fluents) {
    key_.assign(1, stream.index());
    key_.insert(key_.end(), inputs.begin(), inputs.end());
    for (const ValueAtom& atom : fluents) key_.insert(key_.end(), atom.begin(), atom.end());
    SampleList& list = lists_[key_];
    if (list.inputs.empty() && list.fluents.empty()) {
        list.inputs.assign(inputs.size(), false);
        list.fluents.assign(fluents.size(), false);
    }
    return list;
}

bool Samples::extend(SampleList& list, StreamId stream, std::span<const ValueNumber> inputs,
                     std::span<const ValueAtom> fluents, const ActionText& action) {
    if (list.finished) return false;
    const StreamInfo& limits = info(stream);
    std::vector<Value> input_values;
    std::uint64_t fingerprint =
        mix(problem_.options.seed, hash_text(problem_.task->streams[stream.index()].name));
    for (const ValueNumber input : inputs) {
        input_values.push_back(values_[input]);
        fingerprint = mix(fingerprint, fingerprints_[input]);
    }
    std::vector<Value> arguments;
    std::size_t argument_count = 0;
    for (const ValueAtom& atom : fluents) argument_count += atom.size() - 1;
    arguments.reserve(argument_count);
    std::vector<FluentAtom> atoms;
    std::uint64_t state = 0;
    for (const ValueAtom& atom : fluents) {
        const std::size_t begin = arguments.size();
        std::uint64_t own = atom[0];
        for (std::size_t i = 1; i < atom.size(); ++i) {
            arguments.push_back(values_[atom[i]]);
            own = mix(own, fingerprints_[atom[i]]);
        }
        state += own;
        atoms.push_back(
            {problem_.task->task->predicates[atom[0]].name, {arguments.data() + begin, atom.size() - 1}});
    }
    fingerprint = mix(mix(fingerprint, state), list.attempts);
    StreamCall request{problem_.task->streams[stream.index()].name,
                       input_values,
                       list.attempts,
                       atoms,
                       Random(fingerprint),
                       budget_};
    StreamResult result = call(stream, request);
    ++list.attempts;
    ++statistics_.stream_calls;
    effort_ += limits.effort;
    const bool found = result.kind == StreamResult::Kind::sample;
    if (found)
        accept(list, stream, std::move(result), fingerprint);
    else
        reject(list, stream, result, action);
    if (!list.finished && list.attempts >= limits.max_attempts) {
        list.finished = true;
        list.definite = false;
    }
    return found;
}

StreamResult Samples::call(StreamId stream, StreamCall& request) const {
    const StreamSchema& schema = problem_.task->streams[stream.index()];
    StreamResult result;
    try {
        result = streams_[stream.index()]->callback(request);
    } catch (const std::exception& error) {
        throw StreamError(describe(stream, request.inputs) + ": " + error.what());
    } catch (...) {
        throw StreamError(describe(stream, request.inputs) + ": an exception of an unknown kind");
    }
    if (result.kind == StreamResult::Kind::sample && result.outputs.size() != schema.output_count())
        throw StreamError(describe(stream, request.inputs) + " gave " +
                          std::to_string(result.outputs.size()) + " outputs; " +
                          std::to_string(schema.output_count()) + " are declared");
    const auto check = [&](std::span<const std::uint32_t> indices, std::size_t size, const char* what) {
        if (std::ranges::any_of(indices, [&](std::uint32_t index) { return index >= size; }))
            throw StreamError(describe(stream, request.inputs) + " blames " + what + " that it did not get");
    };
    check(result.blame.fluents, request.fluents.size(), "a fluent");
    check(result.blame.inputs, request.inputs.size(), "an input");
    return result;
}

void Samples::accept(SampleList& list, StreamId stream, StreamResult result, std::uint64_t fingerprint) {
    const StreamSchema& schema = problem_.task->streams[stream.index()];
    ++statistics_.samples;
    ++list.count;
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
        const auto number = static_cast<ValueNumber>(values_.size());
        const std::string& variable = schema.scope.variable_names[schema.input_count() + i];
        values_.push_back(result.outputs[i].named('#' + variable.substr(1) + std::to_string(number)));
        fingerprints_.push_back(mix(fingerprint, i + 1));
        list.outputs.push_back(number);
    }
    if (schema.output_count() == 0 || list.count >= info(stream).max_samples) list.finished = true;
}

void Samples::reject(SampleList& list, StreamId stream, const StreamResult& result,
                     const ActionText& action) {
    const StreamSchema& schema = problem_.task->streams[stream.index()];
    const Blame& blame = result.blame;
    const bool exhausted = result.kind == StreamResult::Kind::exhaustion;
    ++statistics_.rejections[schema.name];
    blame_fluents(list, blame);
    if (blame.inputs.empty()) list.inputs.assign(list.inputs.size(), true);
    for (const std::uint32_t i : blame.inputs) list.inputs[i] = true;
    const bool for_good = schema.output_count() == 0 || info(stream).max_samples == 1;
    if (exhausted || (for_good && blame.definite)) list.finished = true;
    if (exhausted && !blame.definite) list.definite = false;
    if (exhausted && list.attempts > 1 && blame.message.empty()) return;
    Attempt attempt{
        action.text(), schema.name, blame.reason, blame.message, blame.definite, blame.picture, 0};
    Attempt& kept =
        attempts_.try_emplace({attempt.action, attempt.stream, attempt.reason, attempt.message}, attempt)
            .first->second;
    ++kept.count;
    kept.picture = blame.picture;
    kept.definite = kept.definite && blame.definite;
}

void Samples::blame_fluents(SampleList& list, const Blame& blame) {
    const bool first = list.attempts == 1;
    if (!blame.each) {
        for (const std::uint32_t i : blame.fluents) list.fluents[i] = true;
        list.each.clear();
        return;
    }
    if (blame.fluents.empty()) return;
    const auto known = [&](std::uint32_t i) { return static_cast<bool>(list.fluents[i]); };
    if (std::ranges::none_of(blame.fluents, known)) list.fluents[blame.fluents.front()] = true;
    if (first)
        list.each = blame.fluents;
    else
        std::erase_if(list.each, [&](std::uint32_t i) {
            return std::ranges::find(blame.fluents, i) == blame.fluents.end();
        });
}

double Samples::cost(std::size_t function, std::span<const ValueNumber> arguments) const {
    const FunctionSchema& schema = problem_.task->functions[function];
    const std::string& name = problem_.task->task->functions[schema.function.index()].name;
    std::vector<Value> inputs;
    std::string text = "function '" + name + "' of (";
    for (const ValueNumber argument : arguments) {
        inputs.push_back(values_[argument]);
        text += (inputs.size() > 1 ? " " : "") + values_[argument].name();
    }
    double cost = 0;
    try {
        cost = functions_[function]->callback(inputs);
    } catch (const std::exception& error) {
        throw StreamError(text + "): " + error.what());
    } catch (...) {
        throw StreamError(text + "): an exception of an unknown kind");
    }
    if (!(cost >= 0) || !std::isfinite(cost))
        throw StreamError(text + ") gave " + std::to_string(cost) + ", which is no cost");
    return cost;
}

std::vector<Attempt> Samples::attempts() const {
    std::vector<Attempt> result;
    for (const auto& [key, attempt] : attempts_) result.push_back(attempt);
    std::ranges::stable_sort(result, std::ranges::greater{}, &Attempt::count);
    return result;
}

void Samples::add_facts(std::vector<ValueNumber> values, std::vector<StreamFact>& facts) const {
    struct Source {
        const Tuple* key = nullptr;
        const SampleList* list = nullptr;
        std::size_t first = 0;  ///< of its outputs in the list
    };
    std::vector<bool> used(values_.size(), false);
    std::vector<Source> makers(values_.size());
    std::vector<Source> tests;
    for (const auto& [key, list] : lists_) {
        const StreamSchema& schema = problem_.task->streams[key.front()];
        if (!schema.fluents.empty() || list.count == 0) continue;
        if (schema.output_count() == 0) tests.push_back({&key, &list, 0});
        for (std::size_t i = 0; i < list.outputs.size(); ++i)
            makers[list.outputs[i]] = {&key, &list, i - i % schema.output_count()};
    }
    std::vector<Source> sources;
    while (!values.empty()) {
        const ValueNumber value = values.back();
        values.pop_back();
        if (used[value]) continue;
        used[value] = true;
        const Source& maker = makers[value];
        if (maker.key == nullptr) continue;
        values.insert(values.end(), maker.key->begin() + 1, maker.key->end());
        const std::size_t count = problem_.task->streams[maker.key->front()].output_count();
        const auto outputs = std::span(maker.list->outputs).subspan(maker.first, count);
        if (std::ranges::none_of(outputs,
                                 [&](ValueNumber output) { return output != value && used[output]; }))
            sources.push_back(maker);
    }
    std::ranges::sort(tests, {}, [](const Source& test) { return *test.key; });
    for (const Source& test : tests)
        if (std::all_of(test.key->begin() + 1, test.key->end(), [&](ValueNumber v) { return used[v]; }))
            sources.push_back(test);
    for (const Source& source : sources) {
        StreamFact& fact = facts.emplace_back();
        fact.stream = StreamId(source.key->front());
        for (std::size_t i = 1; i < source.key->size(); ++i) fact.inputs.push_back(values_[(*source.key)[i]]);
        const std::size_t count = problem_.task->streams[fact.stream.index()].output_count();
        for (std::size_t i = 0; i < count; ++i)
            fact.outputs.push_back(values_[source.list->outputs[source.first + i]]);
    }
}

std::string Samples::describe(StreamId stream, std::span<const Value> inputs) const {
    std::string text = "stream '" + problem_.task->streams[stream.index()].name + "' of (";
    for (std::size_t i = 0; i < inputs.size(); ++i) text += (i > 0 ? " " : "") + inputs[i].name();
    return text + ")";
}

}  // namespace praxis::tamp
