// Derived predicates: after a state is loaded, the atoms that the axioms derive are added to the database.
//
// Axioms are evaluated stratum by stratum, in each until nothing new is derived. Predicates that depend on
// nothing that changes are derived once, for good.
#pragma once

#include <vector>

#include "search/lifted/query.hpp"
#include "search/lifted/query_solver.hpp"

namespace praxis::lifted {

class Axioms {
  public:
    /// Compiles the axioms; `finish` is to be called once the database is finished.
    Axioms(Database& database, QuerySolver& solver);

    /// No predicate depends on its own negation.
    static bool stratified(const LiftedTask& task);

    /// Derives what never changes.
    void finish() { derive(constant_, true); }
    /// Derives what follows in the present state.
    void derive() { derive(changing_, false); }

  private:
    struct Compiled {
        PredicateNumber predicate;
        std::uint32_t arity;
        std::vector<Query> alternatives;
        std::vector<ObjectNumber> binding;
    };
    struct Stratum {
        std::vector<Compiled> axioms;
        bool recursive = false;
    };

    void derive(std::vector<Stratum>& strata, bool for_good);
    bool derive(Compiled& axiom, bool for_good);

    Database& database_;
    QuerySolver& solver_;
    std::vector<Stratum> constant_, changing_;
    std::vector<ObjectNumber> heads_;  ///< arguments of the heads derived in one go
};

}  // namespace praxis::lifted
