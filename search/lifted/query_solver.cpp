#include "search/lifted/query_solver.hpp"

namespace praxis::lifted {

QuerySolver::Choice QuerySolver::choose(const Query& query, std::uint32_t depth,
                                        const ObjectNumber* binding) {
    Choice best;
    for (std::uint32_t i = depth; i < query.order.size(); ++i) {
        const Query::Atom& atom = query.atoms[query.order[i]];
        View& view = database_[atom.view];
        Choice here{i, kNoColumn, view.size()};
        for (std::uint32_t slot = 0; slot < view.width(); ++slot) {
            const ObjectNumber object = binding[query.slots[atom.begin + slot]];
            if (object == kUnbound) continue;
            const View::Row rows = view.count(slot, object);
            if (here.column != kNoColumn && rows >= here.rows) continue;
            here.column = slot;
            here.rows = rows;
        }
        if (here.rows < best.rows) best = here;
        if (best.rows == 0) break;
    }
    return best;
}

bool QuerySolver::passes(Query& query, const Query::Test& test, const ObjectNumber* binding) const {
    if (test.kind == Query::Test::Kind::absent) {
        if (relaxed_) return true;
        for (std::uint32_t i = test.begin; i < test.end; ++i) {
            const ObjectNumber object = value(query.terms[i], binding);
            if (object == kUnbound) return true;
            query.tuple[i - test.begin] = object;
        }
        return !database_.holds(test.predicate, query.tuple.data());
    }
    const ObjectNumber left = value(test.left, binding);
    const ObjectNumber right = value(test.right, binding);
    if (left == kUnbound || right == kUnbound) return true;
    return (left == right) == (test.kind == Query::Test::Kind::equal);
}

bool QuerySolver::solvable(std::vector<Query>& alternatives, ObjectNumber* binding) {
    for (Query& query : alternatives)
        if (solve(query, binding, [] {})) return true;
    return false;
}

bool QuerySolver::checks_hold(Query& query, ObjectNumber* binding) {
    for (Query::Check& check : query.checks)
        if ((check.wanted || !relaxed_) && solvable(check.alternatives, binding) != check.wanted)
            return false;
    return true;
}

bool QuerySolver::look() {
    countdown_ = kTicks;
    stopped_ = stopped_ || budget_.exhausted() != Stop::none;
    if (stopped_) countdown_ = 1;
    return !stopped_;
}

}  // namespace praxis::lifted
