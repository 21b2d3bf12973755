// From conditions to queries.
#pragma once

#include <cstdint>
#include <vector>

#include "search/ground/condition.hpp"
#include "search/lifted/query.hpp"

namespace praxis::lifted {

class QueryCompiler {
  public:
    QueryCompiler(Database& database, const std::vector<TypeId>& variable_types)
        : database_(database), types_(variable_types) {}

    /// Queries of which one at least has a solution whenever the condition holds, and only then. `own`: the
    /// variables to be given values, of which solutions are told apart by `distinguish`.
    std::vector<Query> compile(const grounding::Condition& condition, const std::vector<std::uint32_t>& own,
                               const std::vector<std::uint32_t>& distinguish);

  private:
    /// A conjunction, and the existential variables that were drawn out of it.
    struct Conjunct {
        std::vector<const grounding::Condition*> parts;
        std::vector<std::uint32_t> exists;
    };
    static std::vector<Conjunct> alternatives(const grounding::Condition& condition);
    static std::vector<Conjunct> product(const std::vector<grounding::Condition>& children);

    /// Adds the query of one conjunction, unless it can never hold.
    void add(const Conjunct& conjunct, std::vector<std::uint32_t> own,
             const std::vector<std::uint32_t>& distinguish, std::vector<Query>& result);
    bool solve_equations(const Conjunct& conjunct, Query& query);
    void add_atom(const grounding::Condition& literal, Query& query);
    void add_type(std::uint32_t variable, TypeId type, Query& query);
    void add_absent(const grounding::Condition& literal, Query& query);
    void add_check(const grounding::Condition& condition, Query& query);
    void add_comparison(Query::Test::Kind kind, TermCode left, TermCode right, Query& query);
    static void list_tests(Query& query, std::size_t variable_count);

    TermCode resolve(Term term) const;
    bool is_own(TermCode term) const { return term >= 0 && own_[static_cast<std::size_t>(term)]; }

    Database& database_;
    const std::vector<TypeId>& types_;
    std::vector<bool> own_;               ///< by variable, of the query in the making
    std::vector<bool> joined_;            ///< by variable: in an atom
    std::vector<TermCode> substitution_;  ///< by variable: what an equation says it is
    bool possible_ = true;
};

}  // namespace praxis::lifted
