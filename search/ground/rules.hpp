// The Datalog program that relaxed reachability evaluates, and its making from conditions.
#pragma once

#include <vector>

#include "search/ground/condition.hpp"
#include "search/ground/join.hpp"
#include "search/ground/relations.hpp"

namespace praxis::grounding {

/// head :- body. Variables are those of the scope the rule was made in.
struct Rule {
    RelationId head = 0;
    std::vector<Term> head_terms;
    Body body;
    const std::vector<TypeId>* variable_types = nullptr;  ///< of the scope; outlives the rule
    bool distinct = false;  ///< different bindings give different heads, and no other rule has this head
};

/// Turns conditions into rule bodies, adding helper relations and their rules as needed.
class RuleMaker {
  public:
    RuleMaker(Relations& relations, const std::vector<bool>& exact, std::vector<Rule>& rules)
        : relations_(relations), exact_(exact), rules_(rules) {}

    /// Bodies whose disjunction is implied by the condition; none: the condition is false.
    std::vector<Body> alternatives(const Condition& condition, const std::vector<TypeId>& variable_types);

    /// Something was dropped since the last `start_exact`.
    bool relaxed() const { return relaxed_; }
    void start_exact() { relaxed_ = false; }

  private:
    std::vector<Body> conjunction_of(std::vector<std::vector<Body>> parts, const std::vector<TypeId>& types);
    /// One atom over a helper relation that holds if some alternative does.
    std::vector<Body> helper(const std::vector<Body>& parts, const std::vector<std::uint32_t>& outer,
                             const std::vector<TypeId>& types);

    Relations& relations_;
    const std::vector<bool>& exact_;
    std::vector<Rule>& rules_;
    bool relaxed_ = false;
};

}  // namespace praxis::grounding
