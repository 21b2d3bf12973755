// Tasks with streams: a PDDL task, and a third file that declares where values come from
// (docs/stream-language.md).
//
// A *stream* takes objects (its inputs) of which its domain holds and makes new ones (its outputs) of which
// it certifies atoms; without outputs it is a *test*. A *function* gives costs. What is certified is never
// changed by actions and never negated where it would have to hold, so that more samples can only make more
// possible.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/task.hpp"

namespace praxis {

using StreamId = Id<struct StreamTag>;

/// A predicate of variables of a scope and objects.
struct LiftedAtom {
    PredicateId predicate;
    std::vector<Term> terms;
};

struct StreamSchema {
    std::string name;
    Scope scope;                                    ///< the inputs (`parameter_count`), then the outputs
    std::vector<LiftedAtom> domain;                 ///< all must hold of the inputs
    std::vector<LiftedAtom> certified;              ///< of inputs and outputs
    std::vector<std::vector<TypeId>> output_types;  ///< by output: all types that it belongs to
    std::vector<PredicateId> fluents;               ///< the call gets the atoms of these that hold
    Location where;

    std::size_t input_count() const { return scope.parameter_count; }
    std::size_t output_count() const { return scope.variable_types.size() - scope.parameter_count; }
};

/// Values of a function of the domain, for all tuples that satisfy `domain`.
struct FunctionSchema {
    FunctionId function;
    Scope scope;
    std::vector<LiftedAtom> domain;
    Location where;
};

struct StreamTask {
    Task task;
    std::string name;  ///< of the stream file
    std::vector<StreamSchema> streams;
    std::vector<FunctionSchema> functions;
    std::vector<bool> certified;  ///< by predicate: some stream certifies it
};

struct StreamLoadResult {
    StreamTask task;
    std::vector<Diagnostic> warnings;
};

/// Reads the three files ("-": standard input, for one of them). Throws InputError or UnsupportedError, as
/// `load` does.
StreamLoadResult load_streams_with_warnings(const std::string& domain_file, const std::string& problem_file,
                                            const std::string& stream_file);
StreamTask load_streams(const std::string& domain_file, const std::string& problem_file,
                        const std::string& stream_file);
/// The same from texts in memory.
StreamLoadResult parse_streams(Source domain, Source problem, Source streams);

}  // namespace praxis
