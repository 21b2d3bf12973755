// The lifted planning task: what a checked PDDL domain and problem say, with every name resolved to an id.
//
// Vocabulary. A *scope* (schema, axiom or goal) owns numbered *variables*: the parameters come first (0..n-1),
// variables bound by quantifiers inside the scope follow, each with a number of its own. A *term* is a variable
// of the scope or an object. *Formulas* keep the shape that was written (the validator reads them as they
// stand); *effects* are flattened: nested `and`, `forall` and `when` become a list of single adds and deletes, each
// with the variables that range over it and the condition under which it happens. Every node keeps its place in the
// source, for errors that only later stages can find.
//
// The task owns everything it refers to and is immutable after `load`; it may be shared between threads.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/ids.hpp"
#include "parser/rational.hpp"
#include "parser/source.hpp"

namespace praxis {

/// A set of objects. `either` types appear as anonymous types named "(either a b)".
struct Type {
    std::string name;
    std::vector<TypeId> parents;    ///< direct supertypes; empty for `object`
    std::vector<ObjectId> objects;  ///< all objects of the type and of its subtypes, in increasing order
    std::vector<bool> contains;     ///< by object index: membership in `objects`
    Location where;
};

struct Predicate {
    std::string name;
    std::vector<TypeId> parameters;
    bool derived = false;  ///< the head of an axiom; never in an effect
    bool fluent = false;   ///< added or deleted by some effect
    Location where;
};

struct Function {
    std::string name;
    std::vector<TypeId> parameters;
    Location where;
};

struct Object {
    std::string name;
    TypeId type;
    Location where;
};

/// A variable of the enclosing scope, or an object.
class Term {
  public:
    static constexpr Term variable(std::size_t index) { return Term(static_cast<std::int32_t>(index)); }
    static constexpr Term object(ObjectId id) { return Term(~static_cast<std::int32_t>(id.index())); }

    constexpr bool is_variable() const { return code_ >= 0; }
    constexpr std::uint32_t variable_index() const { return static_cast<std::uint32_t>(code_); }
    constexpr ObjectId object_id() const { return ObjectId(static_cast<std::uint32_t>(~code_)); }
    friend constexpr bool operator==(Term, Term) = default;

  private:
    constexpr explicit Term(std::int32_t code) : code_(code) {}
    std::int32_t code_;
};

enum class Connective : std::uint8_t {
    truth,        ///< also the missing or empty formula
    falsity,      ///< an empty disjunction
    atom,         ///< `predicate` of `terms`
    equality,     ///< two `terms`
    negation,     ///< one child
    conjunction,  ///< any number of children
    disjunction,
    implication,  ///< two children
    existential,  ///< binds `variables` in its one child
    universal,
};

struct Formula {
    Connective kind = Connective::truth;
    PredicateId predicate;
    std::vector<Term> terms;
    std::vector<std::uint32_t> variables;  ///< quantifiers: the scope's variables bound here
    std::vector<Formula> children;
    Location where;
};

/// Numbered variables with their types and the names they were written with (for messages).
struct Scope {
    std::vector<TypeId> variable_types;
    std::vector<std::string> variable_names;  ///< with the question mark
    std::uint32_t parameter_count = 0;        ///< variables 0..parameter_count-1 are parameters
};

/// One add or delete, for every binding of `variables` for which `condition` holds in the state before.
/// Where one action both adds and deletes an atom, the add wins.
struct Effect {
    std::vector<std::uint32_t> variables;
    Formula condition;
    bool add = true;
    PredicateId predicate;
    std::vector<Term> terms;
    Location where;
};

/// A numeric expression over constants and static functions; exact.
struct Expression {
    enum class Kind : std::uint8_t { constant, function, add, subtract, multiply, divide, negate };
    Kind kind = Kind::constant;
    Rational value;
    FunctionId function;
    std::vector<Term> terms;
    std::vector<Expression> children;
    Location where;
};

/// An action with parameters.
struct Schema {
    std::string name;
    Scope scope;
    Formula precondition;
    std::vector<Effect> effects;
    std::optional<Expression> cost;  ///< what it adds to total-cost; none: nothing
    Location where;
};

/// `predicate`(parameters of the scope) holds if `body` does. A predicate may have several axioms.
struct Axiom {
    PredicateId predicate;
    Scope scope;
    Formula body;
    Location where;
};

/// The tuples for which one predicate holds, packed one after the other.
struct Relation {
    std::uint32_t arity = 0;
    std::size_t count = 0;
    std::vector<ObjectId> arguments;  ///< count * arity

    std::span<const ObjectId> tuple(std::size_t i) const { return {arguments.data() + i * arity, arity}; }
};

/// Initial values of one function: values[i] belongs to tuples.tuple(i).
struct FunctionTable {
    Relation tuples;
    std::vector<Rational> values;
};

/// A checked planning task. Semantics as in PDDL 2.2 with action costs: closed world, `=` is built in.
struct LiftedTask {
    std::string domain_name;
    std::string problem_name;
    std::vector<Type> types;  ///< types[0] is `object`
    std::vector<Predicate> predicates;
    std::vector<Function> functions;
    std::vector<Object> objects;
    std::vector<Schema> schemas;
    std::vector<Axiom> axioms;
    std::vector<Relation> initial_atoms;         ///< by predicate; without duplicates
    std::vector<FunctionTable> initial_values;   ///< by function; without duplicates
    Scope goal_scope;
    Formula goal;
    bool minimize_cost = false;  ///< `:metric minimize (total-cost)`; otherwise each action costs one
    std::shared_ptr<const Sources> sources;
};

using Task = std::shared_ptr<const LiftedTask>;

}  // namespace praxis
