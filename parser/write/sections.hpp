// The sections of a domain and of a problem that every task has, as text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parser/task.hpp"

namespace praxis::write {

/// "(define (domain NAME) (:requirements ...) (:types ...) ... (:functions ...)"; `flags` are further
/// requirements.
void domain_head(const LiftedTask& task, const std::string& flags, std::string& out);

void axioms(const LiftedTask& task, std::string& out);

class ScopeText;

/// What a schema does beside its effects: appends to the conjunction of effects, and behind it.
struct SchemaExtras {
    std::function<void(ScopeText&)> effects;  ///< empty if there are none
    std::function<void(ScopeText&)> parts;    ///< further `:keyword ...`; empty if there are none
};

void schema(const LiftedTask& task, const Schema& schema, const SchemaExtras& extras, std::string& out);

/// "  (HEAD a b - t c - u)\n" of those objects for which `chosen` is true; nothing if there are none.
void objects(const LiftedTask& task, const char* head, const std::vector<bool>& chosen, std::string& out);

/// By object: it is a constant of the domain.
std::vector<bool> constants(const LiftedTask& task);

/// "    (p a b)\n" and "    (= (f a) 2)\n" of the initial state.
void initial_facts(const LiftedTask& task, std::string& out);

/// "(p a b)"
void ground_atom(const LiftedTask& task, PredicateId predicate, std::span<const ObjectId> arguments,
                 std::string& out);

/// "  (:goal ...)\n" and the metric.
void goal(const LiftedTask& task, std::string& out);

}  // namespace praxis::write
