#include "search/lifted/axioms.hpp"

#include <algorithm>
#include <optional>

#include "search/ground/condition.hpp"
#include "search/lifted/query_compiler.hpp"

namespace praxis::lifted {

using grounding::Condition;

namespace {

template <class Visit>
void for_each_literal(const Condition& condition, const Visit& visit) {
    if (condition.kind == Condition::Kind::literal) visit(condition);
    for (const Condition& child : condition.children) for_each_literal(child, visit);
}

/// By predicate: those it depends on positively are in its stratum or a lower one, those it depends on
/// negatively in a lower one. Nothing if there are no such numbers.
std::optional<std::vector<std::size_t>> strata_of(const LiftedTask& task,
                                                  const std::vector<Condition>& bodies) {
    std::vector<std::size_t> strata(task.predicates.size(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            std::size_t& head = strata[task.axioms[i].predicate.index()];
            for_each_literal(bodies[i], [&](const Condition& literal) {
                if (!task.predicates[literal.predicate.index()].derived) return;
                const std::size_t least = strata[literal.predicate.index()] + (literal.negated ? 1 : 0);
                changed = changed || least > head;
                head = std::max(head, least);
            });
            if (head > task.predicates.size()) return std::nullopt;
        }
    }
    return strata;
}

std::vector<Condition> bodies_of(const LiftedTask& task) {
    std::vector<Condition> bodies;
    for (const Axiom& axiom : task.axioms) bodies.push_back(grounding::normalise(axiom.body));
    return bodies;
}

}  // namespace

bool Axioms::stratified(const LiftedTask& task) {
    return strata_of(task, bodies_of(task)).has_value();
}

Axioms::Axioms(Database& database, QuerySolver& solver) : database_(database), solver_(solver) {
    const LiftedTask& task = database.task();
    const std::vector<Condition> bodies = bodies_of(task);
    const std::vector<std::size_t> strata = strata_of(task, bodies).value();

    std::vector<bool> changes(task.predicates.size());
    for (std::size_t p = 0; p < changes.size(); ++p) changes[p] = task.predicates[p].fluent;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for_each_literal(bodies[i], [&](const Condition& literal) {
                const std::size_t head = task.axioms[i].predicate.index();
                if (!changes[literal.predicate.index()] || changes[head]) return;
                changes[head] = changed = true;
            });
    }

    constant_.resize(task.axioms.empty() ? 0 : *std::ranges::max_element(strata) + 1);
    changing_.resize(constant_.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Axiom& axiom = task.axioms[i];
        const std::size_t head = axiom.predicate.index();
        Stratum& stratum = (changes[head] ? changing_ : constant_)[strata[head]];
        Compiled compiled{axiom.predicate.index(), axiom.scope.parameter_count, {}, {}};
        compiled.binding.assign(axiom.scope.variable_types.size(), QuerySolver::kUnbound);
        std::vector<std::uint32_t> parameters(compiled.arity);
        for (std::uint32_t v = 0; v < compiled.arity; ++v) parameters[v] = v;
        compiled.alternatives =
            QueryCompiler(database, axiom.scope.variable_types).compile(bodies[i], parameters, parameters);
        for_each_literal(bodies[i], [&](const Condition& literal) {
            const std::size_t other = literal.predicate.index();
            stratum.recursive =
                stratum.recursive || (task.predicates[other].derived && strata[other] == strata[head]);
        });
        stratum.axioms.push_back(std::move(compiled));
    }
}

bool Axioms::derive(Compiled& axiom, bool for_good) {
    heads_.clear();
    std::size_t count = 0;
    for (Query& query : axiom.alternatives)
        solver_.solve(query, axiom.binding.data(), [&] {
            if (database_.holds(axiom.predicate, axiom.binding.data())) return;
            heads_.insert(heads_.end(), axiom.binding.begin(), axiom.binding.begin() + axiom.arity);
            ++count;
        });
    for (std::size_t i = 0; i < count; ++i)
        database_.derive(database_.intern(axiom.predicate, heads_.data() + i * axiom.arity), for_good);
    return count != 0;
}

void Axioms::derive(std::vector<Stratum>& strata, bool for_good) {
    for (Stratum& stratum : strata) {
        for (bool changed = true; changed && !solver_.stopped();) {
            changed = false;
            for (Compiled& axiom : stratum.axioms) changed = derive(axiom, for_good) || changed;
            changed = changed && stratum.recursive;
        }
    }
}

}  // namespace praxis::lifted
