// What is certain about the first state, to compare hidden worlds with it.
#pragma once

#include <vector>

#include "parser/check/context.hpp"
#include "parser/check/tuples.hpp"

namespace praxis::check {

/// Sets of ground atoms of one task. Made when `unknown`, the clauses and the variables are known.
class Certainty {
  public:
    /// `initial_atoms` by predicate; must outlive this.
    Certainty(Context& context, const std::vector<TupleIndex>& initial_atoms);
    Certainty(const Certainty&) = delete;
    Certainty& operator=(const Certainty&) = delete;

    /// Reports a literal that contradicts what `:init` states (an error), and an atom that is false since
    /// nothing says that it may be true (a warning, once for a predicate).
    void check(const GroundLiteral& literal);

  private:
    class Atoms {
      public:
        explicit Atoms(const LiftedTask& task);
        void insert(const GroundLiteral& literal);
        bool contains(const GroundLiteral& literal) const;

      private:
        std::vector<Relation> relations_;
        std::vector<TupleIndex> indices_;
    };

    Context& context_;
    const std::vector<TupleIndex>& initial_atoms_;
    Atoms uncertain_;
    Atoms false_;
    std::vector<bool> warned_;  ///< by predicate
};

}  // namespace praxis::check
