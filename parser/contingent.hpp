// The contingent planning task: a lifted task in which not everything is known at first, and in which actions
// and sensors tell something about the true state. What a checked partially observable PDDL domain and
// problem say.
//
// Three dialects are read, also mixed (see docs/belief-language.md):
//   - CLG / Contingent-FF: `:observe` in actions; `unknown`, `oneof`, `or` in `:init`;
//   - K-replanner: `(:sensor ...)`, `invariant`, `at-least-one`, `at-most-one`, `exactly-one`, `(:hidden
//   ...)`;
//   - multi-valued variables: `:variable`, `:obs-variable`, `:sensing-model`, `:default-sensing-model`.
// Ours besides: `(:open-world p ...)` (atoms of p that `:init` does not mention are unknown), the effect
// `(unknown (p ?x))` (knowledge is lost), `(:decay p N)` (knowledge lasts N steps) and `(:hidden-objects
// ...)` (objects of the world that have to be found).
//
// Vocabulary. An atom is *certain* if every state that may be the first one agrees about it, else
// *uncertain*. The *world* is the true state; a *hidden world* lists the literals by which it differs from
// what is certain (uncertain atoms that it does not mention are false in it).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/task.hpp"

namespace praxis {

/// A ground atom or its negation, in the initial description.
struct GroundLiteral {
    PredicateId predicate;
    std::vector<ObjectId> arguments;
    bool negated = false;
    Location where;
};

/// How many of the literals hold.
enum class ClauseKind : std::uint8_t {
    at_least_one,  ///< `or`, `invariant`, `at-least-one`
    at_most_one,   ///< `at-most-one`; always an invariant
    exactly_one,   ///< `oneof`, `exactly-one`
};

struct Clause {
    ClauseKind kind = ClauseKind::at_least_one;
    std::vector<GroundLiteral> literals;
    /// Written as an invariant: holds in every reachable state, not only in the first one.
    bool invariant = false;
    Location where;
};

/// What is read: the value of one atom, for every binding of `variables` for which `condition` holds.
struct Observation {
    std::vector<std::uint32_t> variables;
    Formula condition;  ///< truth where nothing is written
    PredicateId predicate;
    std::vector<Term> terms;
    double accuracy = 1;  ///< probability that the reading is right; `(probabilistic 0.8 (p))`
    Location where;
};

/// A passive sensor: wherever its condition holds after an action, it reads atoms.
struct Sensor {
    std::string name;
    Scope scope;
    Formula condition;
    std::vector<Observation> observations;
    Location where;
};

/// One rule of a sensing model: where `condition` holds in the state after the action, the observable atom
/// reads `value`. An atom that no rule with `value` true supports reads false; where a model has no such rule
/// for a predicate, its atoms read true unless a rule says that they read false.
struct SensingRule {
    std::vector<std::uint32_t> variables;
    Formula condition;
    bool value = true;
    PredicateId predicate;
    std::vector<Term> terms;
    Location where;
};

/// What a schema does beside the effects that the lifted task has.
struct SchemaSensing {
    std::vector<Observation> observations;  ///< read in the state after the action
    /// `:sensing-model`: its rules. What the model says about atoms that no `:obs-variable` has is read
    /// directly: such literals are among the observations.
    std::vector<SensingRule> model;
    bool own_model = false;         ///< a `:sensing-model` is written; otherwise the default one counts
    std::vector<Effect> forgotten;  ///< `(unknown (p ?x))`: the atom may be either way afterwards
};

/// A multi-valued variable (multi-valued dialect): exactly one of its atoms holds; with one atom, a boolean.
struct MultiValuedVariable {
    std::string name;  ///< ground: "door-at(c2)", "range(h0 p1)"
    std::vector<GroundLiteral> values;
    bool observable = false;  ///< `:obs-variable`
    Location where;
};

struct HiddenWorld {
    std::vector<GroundLiteral> literals;
    Location where;
};

struct Decay {
    PredicateId predicate;
    std::int64_t steps = 0;
    Location where;
};

struct ContingentTask {
    /// Types, predicates, objects, schemas, axioms, goal. `initial_atoms` are those that are certainly true.
    /// An action with observations alone is a schema without effects.
    Task task;
    std::vector<SchemaSensing> sensing;  ///< by schema
    std::vector<Sensor> sensors;
    std::vector<SensingRule> default_model;  ///< `:default-sensing-model`: of every schema without a model
    std::vector<Observation> default_observations;  ///< likewise, read directly
    Scope default_scope;  ///< of `default_model` and `default_observations`; no parameters
    std::vector<MultiValuedVariable> variables;
    std::vector<GroundLiteral> unknown;      ///< `(unknown l)`, as written; never negated
    std::vector<GroundLiteral> known_false;  ///< negative literals of `:init`, as written
    std::vector<Clause> clauses;
    std::vector<HiddenWorld> hidden;        ///< of the problem and of further world files
    std::vector<bool> open_world;           ///< by predicate
    std::vector<bool> declared_observable;  ///< by predicate: `:observable`
    std::vector<bool> sticky;               ///< by predicate: `:sticky`
    std::vector<Decay> decays;
    std::vector<ObjectId> hidden_objects;  ///< objects of `task` that the agent has to find first

    /// There is something unknown or something to sense: not a classical task.
    bool contingent() const;
};

struct ContingentLoadResult {
    std::shared_ptr<const ContingentTask> task;
    std::vector<Diagnostic> warnings;
};

/// Reads a domain, a problem and any number of world files (`(define (problem X) (:hidden ...) ...)`). A
/// classical task is a contingent one without uncertainty. Throws InputError or UnsupportedError, as `load`
/// does.
ContingentLoadResult load_contingent(const std::string& domain_file, const std::string& problem_file,
                                     const std::vector<std::string>& world_files = {});

/// The same from texts in memory.
ContingentLoadResult parse_contingent(Source domain, Source problem, std::vector<Source> worlds = {});

/// The task as PDDL text again, in the dialects it was written in; reading it gives an equal task.
std::string write_contingent_domain(const ContingentTask& task);
std::string write_contingent_problem(const ContingentTask& task);

}  // namespace praxis
