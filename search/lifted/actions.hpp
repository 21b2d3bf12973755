// The schemas of a task as queries: which actions are applicable in the present state, and what they change.
#pragma once

#include <span>
#include <vector>

#include "parser/task.hpp"
#include "search/ground/condition.hpp"
#include "search/ground/costs.hpp"
#include "search/lifted/query.hpp"
#include "search/lifted/query_solver.hpp"

namespace praxis::lifted {

/// What an action changes: atoms that become true and were not, and the other way round.
struct Change {
    std::vector<AtomNumber> added;
    std::vector<AtomNumber> deleted;
};

class Actions {
  public:
    /// Compiles the schemas; `database.finish` is still to be called, before anything else here.
    Actions(Database& database, QuerySolver& solver);

    /// Calls visit(schema, arguments) for each action applicable in the present state. The same action may be
    /// met more than once if its precondition is a disjunction. `arguments` stay valid during the visit.
    template <class Visit>
    void for_each_applicable(const Visit& visit) {
        for (std::uint32_t number = 0; number < schemas_.size() && !solver_.stopped(); ++number) {
            Compiled& schema = schemas_[number];
            for (Query& query : schema.preconditions)
                solver_.solve(query, schema.binding.data(), [&] {
                    if (!schema.cost_varies || schema.cost.evaluate(schema.binding.data()))
                        visit(number, schema.binding.data());
                });
        }
    }

    /// The change that the action makes in the present state; atoms without a number get one. Valid until the
    /// next call. To be asked from within the visit.
    const Change& change(std::uint32_t schema);
    /// Calls visit(atom, support) for each atom that the action adds and that does not hold: support are the
    /// atoms over fluent predicates that the action and the effect need.
    template <class Visit>
    void for_each_add(std::uint32_t schema, const Visit& visit) {
        Compiled& compiled = schemas_[schema];
        const ObjectNumber* binding = compiled.binding.data();
        for (Outcome& outcome : compiled.outcomes) {
            if (!outcome.add) break;
            const auto add = [&] {
                const AtomNumber atom =
                    database_.intern(outcome.head.predicate, arguments(outcome.head, binding));
                if (database_.holds(atom)) return;
                support_.clear();
                for (const Head& literal : outcome.support)
                    support_.push_back(
                        database_.atoms().find(literal.predicate, arguments(literal, binding)));
                visit(atom, std::span<const AtomNumber>(support_));
            };
            if (outcome.always) add();
            for (Query& condition : outcome.conditions)
                solver_.solve(condition, compiled.binding.data(), add);
        }
    }
    /// What the action costs, by the metric. To be asked from within the visit.
    Rational cost(std::uint32_t schema);

  private:
    struct Head {
        PredicateNumber predicate;
        std::vector<TermCode> terms;
    };
    struct Outcome {
        bool add;
        Head head;
        std::vector<Head> support;
        bool always;                    ///< no condition, no variables
        std::vector<Query> conditions;  ///< else: alternatives
    };
    struct Compiled {
        grounding::CostEvaluator cost;
        bool cost_varies = false;  ///< may be undefined for some arguments
        std::vector<Query> preconditions;
        std::vector<Outcome> outcomes;
        std::vector<ObjectNumber> binding;  ///< by variable of the scope
    };

    void add_support(const grounding::Condition& condition, std::vector<Head>& support) const;
    const ObjectNumber* arguments(const Head& head, const ObjectNumber* binding) {
        for (std::size_t i = 0; i < head.terms.size(); ++i) {
            const TermCode term = head.terms[i];
            tuple_[i] = term >= 0 ? binding[term] : static_cast<ObjectNumber>(~term);
        }
        return tuple_.data();
    }
    void collect(const Outcome& outcome, const ObjectNumber* binding);

    Database& database_;
    QuerySolver& solver_;
    std::vector<Compiled> schemas_;
    Change change_;
    std::vector<ObjectNumber> tuple_;
    std::vector<AtomNumber> support_;
    std::vector<std::uint32_t> added_stamp_;  ///< by atom: the change that adds it
    std::uint32_t stamp_ = 0;
};

}  // namespace praxis::lifted
