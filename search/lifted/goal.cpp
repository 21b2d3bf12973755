#include "search/lifted/goal.hpp"

#include <algorithm>

#include "search/ground/condition.hpp"
#include "search/lifted/query_compiler.hpp"

namespace praxis::lifted {

Goal::Goal(Database& database, QuerySolver& solver) : database_(database), solver_(solver) {
    using Kind = grounding::Condition::Kind;
    const LiftedTask& task = database.task();
    binding_.assign(task.goal_scope.variable_types.size(), QuerySolver::kUnbound);
    QueryCompiler compiler(database, task.goal_scope.variable_types);
    const grounding::Condition goal = grounding::normalise(task.goal);
    for (const grounding::Condition& part : grounding::conjuncts(goal)) {
        if (part.kind == Kind::literal && !task.predicates[part.predicate.index()].derived) {
            Literal literal{part.predicate.index(), {}, part.negated};
            for (const Term term : part.terms) literal.arguments.push_back(term.object_id().index());
            literals_.push_back(std::move(literal));
        } else {
            conditions_.push_back(compiler.compile(part, {}, {}));
            impossible_ = impossible_ || conditions_.back().empty();
        }
    }
}

void Goal::finish() {
    std::erase_if(literals_, [&](const Literal& literal) {
        if (database_.task().predicates[literal.predicate].fluent) return false;
        if (database_.holds(literal.predicate, literal.arguments.data()) == literal.negated)
            impossible_ = true;
        return true;
    });
    for (const Literal& literal : literals_) {
        const AtomNumber atom = database_.intern(literal.predicate, literal.arguments.data());
        if (atom >= signs_.size()) signs_.resize(atom + 1, 0);
        const std::int8_t sign = literal.negated ? -1 : 1;
        if (signs_[atom] == -sign) impossible_ = true;
        if (signs_[atom] == 0 && sign > 0) wanted_.push_back(atom);
        signs_[atom] = sign;
    }
}

std::uint32_t Goal::literals_missing(std::span<const AtomNumber> state) const {
    std::uint32_t missing = static_cast<std::uint32_t>(wanted_.size());
    for (const AtomNumber atom : state) missing -= static_cast<std::uint32_t>(sign(atom));
    return missing;
}

std::uint32_t Goal::literals_missing(std::uint32_t before, const Change& change) const {
    for (const AtomNumber atom : change.added) before -= static_cast<std::uint32_t>(sign(atom));
    for (const AtomNumber atom : change.deleted) before += static_cast<std::uint32_t>(sign(atom));
    return before;
}

std::uint32_t Goal::conditions_missing() {
    return static_cast<std::uint32_t>(std::ranges::count_if(
        conditions_,
        [&](std::vector<Query>& alternatives) { return !solver_.solvable(alternatives, binding_.data()); }));
}

}  // namespace praxis::lifted
