// Solves queries over the present state by backtracking joins.
//
// At every step the atom with the fewest rows left, given the values chosen so far, comes next (fail first),
// so that the order of a join follows the state and the binding instead of an estimate made beforehand: an
// atom without rows ends a branch at once, as a semi-join would (the aim of the full reducers of Corrêa,
// Pommerening, Helmert and Frances, ICAPS 2020, reached by looking ahead). Once the variables that tell
// solutions apart have values, the rest is only a matter of existence and one witness is enough.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "search/budget.hpp"
#include "search/lifted/query.hpp"

namespace praxis::lifted {

class QuerySolver {
  public:
    static constexpr ObjectNumber kUnbound = std::numeric_limits<ObjectNumber>::max();

    QuerySolver(Database& database, const Budget& budget) : database_(database), budget_(budget) {}

    /// Calls emit() for every solution; `binding`, by variable of the scope, then holds its values, and those
    /// before afterwards. Returns whether there was one.
    template <class Emit>
    bool solve(Query& query, ObjectNumber* binding, Emit&& emit);
    /// One of the queries has a solution.
    bool solvable(std::vector<Query>& alternatives, ObjectNumber* binding);

    /// While relaxed, what is required not to hold is ignored.
    void relax(bool relaxed) {
        relaxed_ = relaxed;
        abandoned_ = false;
    }
    /// From within emit(), while relaxed: ends all solving until `relax` is called.
    void abandon() { abandoned_ = true; }

    /// The budget has run out: what was returned since is incomplete.
    bool stopped() const { return stopped_ || abandoned_; }

  private:
    enum class Step : std::uint8_t { exhausted, found, stop };

    template <class Emit>
    Step extend(Query& query, std::uint32_t depth, std::uint32_t missing, ObjectNumber* binding, Emit& emit);
    template <class Emit>
    Step finish(Query& query, ObjectNumber* binding, Emit& emit);

    /// What the atom has left, and the column to look it up by (kNoColumn: none is bound).
    static constexpr std::uint32_t kNoColumn = 0xffffffff;
    struct Choice {
        std::uint32_t position = 0;
        std::uint32_t column = kNoColumn;
        View::Row rows = View::kNoRow;
    };
    Choice choose(const Query& query, std::uint32_t depth, const ObjectNumber* binding);

    static ObjectNumber value(TermCode term, const ObjectNumber* binding) {
        return term >= 0 ? binding[term] : static_cast<ObjectNumber>(~term);
    }
    /// The test holds, or not all its variables have values.
    bool passes(Query& query, const Query::Test& test, const ObjectNumber* binding) const;
    bool checks_hold(Query& query, ObjectNumber* binding);
    bool tick() { return --countdown_ != 0 || look(); }
    bool look();

    Database& database_;
    const Budget& budget_;
    std::uint32_t countdown_ = kTicks;
    bool stopped_ = false;
    bool relaxed_ = false;
    bool abandoned_ = false;
    static constexpr std::uint32_t kTicks = 1 << 14;
};

template <class Emit>
bool QuerySolver::solve(Query& query, ObjectNumber* binding, Emit&& emit) {
    for (const Query::Atom& atom : query.atoms)
        if (database_[atom.view].size() == 0) return false;
    for (std::size_t i = 0; i < query.own.size(); ++i) {
        query.saved[i] = binding[query.own[i]];
        binding[query.own[i]] = kUnbound;
    }
    bool possible = true;
    for (const Query::Test& test : query.tests) possible = possible && passes(query, test, binding);
    const bool found = possible && extend(query, 0, query.distinguish_count, binding, emit) == Step::found;
    for (std::size_t i = 0; i < query.own.size(); ++i) binding[query.own[i]] = query.saved[i];
    return found;
}

template <class Emit>
QuerySolver::Step QuerySolver::finish(Query& query, ObjectNumber* binding, Emit& emit) {
    for (const Query::Copy& copy : query.copies) binding[copy.variable] = value(copy.source, binding);
    Step step = Step::exhausted;
    if (query.checks.empty() || checks_hold(query, binding)) {
        emit();
        step = Step::found;
    }
    for (const Query::Copy& copy : query.copies) binding[copy.variable] = kUnbound;
    return stopped() ? Step::stop : step;
}

template <class Emit>
QuerySolver::Step QuerySolver::extend(Query& query, std::uint32_t depth, std::uint32_t missing,
                                      ObjectNumber* binding, Emit& emit) {
    if (depth == query.order.size()) return finish(query, binding, emit);
    const Choice choice = choose(query, depth, binding);
    if (choice.rows == 0) return Step::exhausted;
    std::swap(query.order[depth], query.order[choice.position]);
    const Query::Atom& atom = query.atoms[query.order[depth]];
    View& view = database_[atom.view];
    const std::uint32_t* variables = query.slots.data() + atom.begin;

    const std::size_t first_new = query.new_slots.size();
    std::uint32_t missing_after = missing;
    for (std::uint32_t slot = 0; slot < view.width(); ++slot) {
        if (binding[variables[slot]] != kUnbound) continue;
        query.new_slots.push_back(slot);
        missing_after -= query.distinguish[variables[slot]];
    }
    const std::size_t end_new = query.new_slots.size();

    Step result = Step::exhausted;
    const bool indexed = choice.column != kNoColumn;
    View::Row row = indexed ? view.first(choice.column, binding[variables[choice.column]]) : 0;
    for (; indexed ? row != View::kNoRow : row < view.size();
         row = indexed ? view.next(choice.column, row) : row + 1) {
        if (!tick()) {
            result = Step::stop;
            break;
        }
        const ObjectNumber* values = view.row(row);
        for (std::size_t i = first_new; i < end_new; ++i)
            binding[variables[query.new_slots[i]]] = values[query.new_slots[i]];
        bool fits = true;
        for (std::uint32_t slot = 0; slot < view.width() && fits; ++slot)
            fits = binding[variables[slot]] == values[slot];
        for (std::size_t i = first_new; i < end_new && fits; ++i) {
            const std::uint32_t variable = variables[query.new_slots[i]];
            for (std::uint32_t t = query.tests_begin[variable]; t < query.tests_begin[variable + 1] && fits;
                 ++t)
                fits = passes(query, query.tests[query.tests_of[t]], binding);
        }
        if (!fits) continue;
        const Step step = extend(query, depth + 1, missing_after, binding, emit);
        if (step == Step::exhausted) continue;
        result = step;
        if (step == Step::stop || missing == 0) break;
    }
    for (std::size_t i = first_new; i < end_new; ++i) binding[variables[query.new_slots[i]]] = kUnbound;
    query.new_slots.resize(first_new);
    return result;
}

}  // namespace praxis::lifted
