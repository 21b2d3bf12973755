// The textbook semantics of a lifted task, as simply as it can be written: a state is a bit for every tuple
// of objects, every quantifier a loop over its type, axioms are repeated passes. A second opinion for what is
// tested; shares no code with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parser/task.hpp"

namespace praxis::test {

class NaiveSemantics {
  public:
    using State = std::vector<bool>;
    using Tuple = std::vector<std::uint32_t>;

    /// Keeps a reference to the task.
    explicit NaiveSemantics(const LiftedTask& task);

    /// The bit of a ground atom.
    std::size_t atom(PredicateId predicate, std::span<const std::uint32_t> arguments) const;
    std::size_t atom_count() const { return first_.back(); }
    /// The first bit of each predicate, and the number of bits.
    const std::vector<std::size_t>& first() const { return first_; }
    /// "predicate object ...".
    std::string atom_name(std::size_t atom) const;

    /// With the derived atoms that hold.
    State initial() const;
    /// Forgets the derived atoms and derives them anew.
    void close(State& state) const;
    bool goal(const State& state) const;

    /// Calls `visit` for every tuple of objects of the parameters' types.
    void instances(const Scope& scope, const std::function<void(const Tuple&)>& visit) const;
    bool applicable(const Schema& schema, const Tuple& arguments, const State& state) const;
    State successor(const Schema& schema, const Tuple& arguments, const State& state) const;
    /// By the metric; nothing if a function has no value there.
    std::optional<Rational> cost(const Schema& schema, const Tuple& arguments) const;

    /// Truth in a state under values of the free variables; values of bound ones are overwritten.
    bool holds(const Formula& formula, const Scope& scope, Tuple& values, const State& state) const;

  private:
    Tuple values_for(const Scope& scope, const Tuple& arguments) const;
    std::size_t atom(PredicateId predicate, const std::vector<Term>& terms, const Tuple& values) const;
    bool any_assignment(const std::vector<std::uint32_t>& variables, std::size_t i, const Scope& scope,
                        Tuple& values, const std::function<bool()>& visit) const;
    void find_strata();
    std::optional<Rational> evaluate(const Expression& expression, const Tuple& values) const;

    const LiftedTask& task_;
    std::vector<std::size_t> first_;
    std::vector<std::size_t> stratum_;  ///< by predicate
};

}  // namespace praxis::test
