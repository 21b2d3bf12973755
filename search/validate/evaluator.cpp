#include "search/validate/evaluator.hpp"

#include <algorithm>

namespace praxis::validation {

using Kind = Condition::Kind;

Evaluator::Evaluator(const LiftedTask& task, std::vector<FactTable>& tables) : task_(task), tables_(tables) {
    std::size_t widest = 1;
    for (const FactTable& table : tables) widest = std::max<std::size_t>(widest, table.arity());
    key_.resize(widest);
}

void Evaluator::enter(const Scope& scope) {
    scope_ = &scope;
    values_.assign(scope.variable_types.size(), kUnbound);
    trail_.clear();
    pending_.clear();
}

bool Evaluator::inhabited(std::span<const std::uint32_t> variables) const {
    return std::all_of(variables.begin(), variables.end(),
                       [this](std::uint32_t v) { return domain_size(v) > 0; });
}

std::uint32_t Evaluator::domain_size(std::uint32_t variable) const {
    return static_cast<std::uint32_t>(task_.types[scope_->variable_types[variable].index()].objects.size());
}

bool Evaluator::admits(std::uint32_t variable, std::uint32_t object) const {
    return task_.types[scope_->variable_types[variable].index()].contains[object];
}

bool Evaluator::bound(const Condition& condition) const {
    return std::all_of(condition.free.begin(), condition.free.end(),
                       [this](std::uint32_t variable) { return values_[variable] != kUnbound; });
}

bool Evaluator::test_atom(const Condition& condition) {
    for (std::size_t i = 0; i < condition.terms.size(); ++i) key_[i] = value(condition.terms[i]);
    return tables_[condition.predicate.index()].contains(key_.data());
}

bool Evaluator::holds(const Condition& condition) {
    switch (condition.kind) {
        case Kind::truth:
            return true;
        case Kind::falsity:
            return false;
        case Kind::atom:
            return test_atom(condition) == condition.positive;
        case Kind::equality:
            return (value(condition.terms[0]) == value(condition.terms[1])) == condition.positive;
        case Kind::all:
            return std::all_of(condition.children.begin(), condition.children.end(),
                               [this](const Condition& child) { return holds(child); });
        case Kind::any:
            return std::any_of(condition.children.begin(), condition.children.end(),
                               [this](const Condition& child) { return holds(child); });
        case Kind::exists:
            return exists(condition);
        case Kind::none:
            return !exists(condition);
    }
    return false;
}

bool Evaluator::exists(const Condition& quantified) {
    if (!inhabited(quantified.variables)) return false;
    const std::size_t begin = pending_.size();
    pending_.push_back(&quantified.children.front());
    const bool found = solve_existence(begin);
    pending_.resize(begin);
    return found;
}

void Evaluator::enumerate(std::span<const Condition* const> conditions, std::span<const std::uint32_t> wanted,
                          const Sink& sink, const Sink* known) {
    const std::size_t begin = pending_.size();
    pending_.insert(pending_.end(), conditions.begin(), conditions.end());
    solve(begin, Query{wanted, &sink, known});
    pending_.resize(begin);
}

bool Evaluator::reduce(std::size_t begin) {
    for (std::size_t i = begin; i < pending_.size();) {
        const Condition* condition = pending_[i];
        if (condition->kind == Kind::all) {
            pending_[i] = pending_.back();
            pending_.pop_back();
            for (const Condition& child : condition->children) pending_.push_back(&child);
        } else if (bound(*condition)) {
            if (!holds(*condition)) return false;
            pending_[i] = pending_.back();
            pending_.pop_back();
        } else {
            ++i;
        }
    }
    return true;
}

bool Evaluator::solve_existence(std::size_t begin) {
    return solve(begin, Query{});
}

bool Evaluator::solve(std::size_t begin, const Query& query) {
    if (!reduce(begin)) return false;
    std::uint32_t variable = kUnbound;
    const auto consider = [&](std::uint32_t candidate) {
        if (values_[candidate] != kUnbound) return;
        if (variable == kUnbound || domain_size(candidate) < domain_size(variable)) variable = candidate;
    };
    if (query.sink) {
        for (const std::uint32_t wanted : query.wanted) consider(wanted);
        if (variable == kUnbound) {
            if (query.known && (*query.known)()) return false;
            return solve_existence(begin) && (*query.sink)();
        }
    }
    if (pending_.size() == begin) {
        return query.sink ? supply_type(variable, begin, query) : true;
    }

    std::size_t best = begin;
    std::uint32_t fewest = kUnbound;
    for (std::size_t i = begin; i < pending_.size(); ++i) {
        const std::uint32_t count = estimate(*pending_[i]);
        if (count < fewest) {
            fewest = count;
            best = i;
        }
    }
    if (fewest == kUnbound) {
        for (std::size_t i = begin; i < pending_.size(); ++i) {
            for (const std::uint32_t candidate : pending_[i]->free) consider(candidate);
        }
        return supply_type(variable, begin, query);
    }
    const Condition* chosen = pending_[best];
    pending_[best] = pending_.back();
    pending_.pop_back();
    return supply(*chosen, begin, query);
}

std::uint32_t Evaluator::bound_positions(const Condition& atom) {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < atom.terms.size() && i < 31; ++i) {
        key_[i] = value(atom.terms[i]);
        if (key_[i] != kUnbound) mask |= std::uint32_t{1} << i;
    }
    return mask;
}

std::uint32_t Evaluator::estimate(const Condition& condition) {
    if (bound(condition)) return 1;
    switch (condition.kind) {
        case Kind::atom: {
            if (!condition.positive) return kUnbound;
            FactTable& table = tables_[condition.predicate.index()];
            const std::uint32_t mask = bound_positions(condition);
            return mask == 0 ? static_cast<std::uint32_t>(table.size())
                             : table.match(mask, key_.data()).count;
        }
        case Kind::equality: {
            const bool supplies =
                value(condition.terms[0]) != kUnbound || value(condition.terms[1]) != kUnbound;
            return condition.positive && supplies ? 1 : kUnbound;
        }
        case Kind::all: {
            std::uint32_t fewest = kUnbound;
            for (const Condition& child : condition.children) {
                if (!bound(child)) fewest = std::min(fewest, estimate(child));
            }
            return fewest;
        }
        case Kind::any: {
            std::uint64_t sum = 0;
            for (const Condition& child : condition.children) sum += estimate(child);
            return static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, kUnbound));
        }
        case Kind::exists:
            return estimate(condition.children.front());
        default:
            return kUnbound;
    }
}

bool Evaluator::supply(const Condition& condition, std::size_t begin, const Query& query) {
    switch (condition.kind) {
        case Kind::atom:
            return supply_atom(condition, begin, query);
        case Kind::equality:
            return supply_equality(condition, begin, query);
        case Kind::exists:
            return inhabited(condition.variables) && descend(begin, &condition.children.front(), query);
        default:
            return std::any_of(condition.children.begin(), condition.children.end(),
                               [&](const Condition& child) { return descend(begin, &child, query); });
    }
}

bool Evaluator::supply_atom(const Condition& atom, std::size_t begin, const Query& query) {
    FactTable& table = tables_[atom.predicate.index()];
    const std::uint32_t mask = bound_positions(atom);
    if (mask == 0) {
        for (std::uint32_t row = 0; row < table.row_count(); ++row) {
            if (table.alive(row) && supply_row(atom, row, begin, query)) return true;
        }
        return false;
    }
    const FactTable::Chain chain = table.match(mask, key_.data());
    for (std::uint32_t row = chain.first; row != FactTable::kNone; row = (*chain.next)[row]) {
        if (table.alive(row) && supply_row(atom, row, begin, query)) return true;
    }
    return false;
}

bool Evaluator::supply_row(const Condition& atom, std::uint32_t row, std::size_t begin, const Query& query) {
    const std::size_t mark = trail_.size();
    const bool fits = unify(atom, tables_[atom.predicate.index()].row(row));
    const bool ended = fits && descend(begin, nullptr, query);
    undo(mark);
    return ended;
}

bool Evaluator::unify(const Condition& atom, const std::uint32_t* tuple) {
    for (std::size_t i = 0; i < atom.terms.size(); ++i) {
        const std::uint32_t known = value(atom.terms[i]);
        if (known == kUnbound) {
            const std::uint32_t variable = atom.terms[i].variable_index();
            if (!admits(variable, tuple[i])) return false;
            values_[variable] = tuple[i];
            trail_.push_back(variable);
        } else if (known != tuple[i]) {
            return false;
        }
    }
    return true;
}

bool Evaluator::supply_equality(const Condition& equality, std::size_t begin, const Query& query) {
    const bool first_bound = value(equality.terms[0]) != kUnbound;
    const std::uint32_t object = value(equality.terms[first_bound ? 0 : 1]);
    const std::uint32_t variable = equality.terms[first_bound ? 1 : 0].variable_index();
    if (!admits(variable, object)) return false;
    const std::size_t mark = trail_.size();
    values_[variable] = object;
    trail_.push_back(variable);
    const bool ended = descend(begin, nullptr, query);
    undo(mark);
    return ended;
}

bool Evaluator::supply_type(std::uint32_t variable, std::size_t begin, const Query& query) {
    const std::size_t mark = trail_.size();
    for (const ObjectId object : task_.types[scope_->variable_types[variable].index()].objects) {
        values_[variable] = object.index();
        trail_.push_back(variable);
        const bool ended = descend(begin, nullptr, query);
        undo(mark);
        if (ended) return true;
    }
    return false;
}

bool Evaluator::descend(std::size_t begin, const Condition* extra, const Query& query) {
    const std::size_t top = pending_.size();
    for (std::size_t i = begin; i < top; ++i) pending_.push_back(pending_[i]);
    if (extra) pending_.push_back(extra);
    const bool ended = solve(top, query);
    pending_.resize(top);
    return ended;
}

void Evaluator::undo(std::size_t mark) {
    while (trail_.size() > mark) {
        values_[trail_.back()] = kUnbound;
        trail_.pop_back();
    }
}

}  // namespace praxis::validation
