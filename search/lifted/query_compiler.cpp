#include "search/lifted/query_compiler.hpp"

#include <algorithm>
#include <utility>

namespace praxis::lifted {

using grounding::Condition;
using Kind = Condition::Kind;

namespace {

/// More conjunctions than this are not multiplied out.
constexpr std::size_t kMostAlternatives = 16;

Condition negation(const Condition& condition) {
    Condition result = condition;
    switch (condition.kind) {
        case Kind::truth:
            result.kind = Kind::falsity;
            break;
        case Kind::falsity:
            result.kind = Kind::truth;
            break;
        case Kind::literal:
        case Kind::equality:
            result.negated = !condition.negated;
            break;
        case Kind::conjunction:
            result.kind = Kind::disjunction;
            break;
        case Kind::disjunction:
            result.kind = Kind::conjunction;
            break;
        case Kind::exists:
            result.kind = Kind::forall;
            break;
        case Kind::forall:
            result.kind = Kind::exists;
            break;
    }
    for (Condition& child : result.children) child = negation(child);
    return result;
}

bool disjoint(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    return std::none_of(a.begin(), a.end(),
                        [&](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

TermCode code(Term term) {
    return term.is_variable() ? static_cast<TermCode>(term.variable_index())
                              : ~static_cast<TermCode>(term.object_id().index());
}

}  // namespace

std::vector<QueryCompiler::Conjunct> QueryCompiler::product(const std::vector<Condition>& children) {
    std::vector<Conjunct> result(1);
    for (const Condition& child : children) {
        std::vector<Conjunct> parts = alternatives(child);
        bool fits = result.size() * parts.size() <= kMostAlternatives;
        for (const Conjunct& left : result)
            for (const Conjunct& right : parts) fits = fits && disjoint(left.exists, right.exists);
        if (!fits) parts = {{{&child}, {}}};
        std::vector<Conjunct> next;
        for (const Conjunct& left : result) {
            for (const Conjunct& right : parts) {
                Conjunct both = left;
                both.parts.insert(both.parts.end(), right.parts.begin(), right.parts.end());
                both.exists.insert(both.exists.end(), right.exists.begin(), right.exists.end());
                next.push_back(std::move(both));
            }
        }
        result = std::move(next);
    }
    return result;
}

std::vector<QueryCompiler::Conjunct> QueryCompiler::alternatives(const Condition& condition) {
    switch (condition.kind) {
        case Kind::truth:
            return std::vector<Conjunct>(1);
        case Kind::falsity:
            return {};
        case Kind::conjunction:
            return product(condition.children);
        case Kind::disjunction: {
            std::vector<Conjunct> result;
            for (const Condition& child : condition.children)
                for (Conjunct& part : alternatives(child)) result.push_back(std::move(part));
            if (result.size() > kMostAlternatives) return {{{&condition}, {}}};
            return result;
        }
        case Kind::exists: {
            std::vector<Conjunct> result = alternatives(condition.children.front());
            for (const Conjunct& part : result)
                if (!disjoint(part.exists, condition.variables)) return {{{&condition}, {}}};
            for (Conjunct& part : result)
                part.exists.insert(part.exists.end(), condition.variables.begin(), condition.variables.end());
            return result;
        }
        default:
            return {{{&condition}, {}}};
    }
}

std::vector<Query> QueryCompiler::compile(const Condition& condition, const std::vector<std::uint32_t>& own,
                                          const std::vector<std::uint32_t>& distinguish) {
    std::vector<Query> result;
    for (const Conjunct& conjunct : alternatives(condition)) {
        // A variable bound again inside means another one there: left to a check.
        if (disjoint(conjunct.exists, own))
            add(conjunct, own, distinguish, result);
        else
            add({{&condition}, {}}, own, distinguish, result);
    }
    return result;
}

TermCode QueryCompiler::resolve(Term term) const {
    TermCode result = code(term);
    while (result >= 0 && substitution_[static_cast<std::size_t>(result)] != result)
        result = substitution_[static_cast<std::size_t>(result)];
    return result;
}

bool QueryCompiler::solve_equations(const Conjunct& conjunct, Query& query) {
    for (const Condition* part : conjunct.parts) {
        if (part->kind != Kind::equality || part->negated) continue;
        TermCode a = resolve(part->terms[0]);
        TermCode b = resolve(part->terms[1]);
        if (a == b) continue;
        if (!is_own(a)) std::swap(a, b);
        if (!is_own(a)) {
            add_comparison(Query::Test::Kind::equal, a, b, query);
            continue;
        }
        substitution_[static_cast<std::size_t>(a)] = b;
    }
    return possible_;
}

void QueryCompiler::add_comparison(Query::Test::Kind kind, TermCode left, TermCode right, Query& query) {
    if ((left < 0 && right < 0) || left == right) {
        possible_ = possible_ && (left == right) == (kind == Query::Test::Kind::equal);
        return;
    }
    query.tests.push_back({kind, left, right, 0, 0, 0});
}

void QueryCompiler::add_atom(const Condition& literal, Query& query) {
    Pattern pattern;
    pattern.predicate = literal.predicate.index();
    Query::Atom atom{0, static_cast<std::uint32_t>(query.slots.size()), 0};
    for (const Term term : literal.terms) {
        const TermCode resolved = resolve(term);
        if (resolved < 0) {
            pattern.columns.push_back(resolved);
            continue;
        }
        const auto variable = static_cast<std::uint32_t>(resolved);
        const auto begin = query.slots.begin() + atom.begin;
        const auto found = std::find(begin, query.slots.end(), variable);
        pattern.columns.push_back(static_cast<std::int32_t>(found - begin));
        if (found != query.slots.end()) continue;
        query.slots.push_back(variable);
        pattern.types.push_back(own_[variable] ? types_[variable].index() : 0);
        joined_[variable] = true;
    }
    atom.end = static_cast<std::uint32_t>(query.slots.size());
    atom.view = database_.view(pattern);
    const auto same = [&](const Query::Atom& other) {
        return other.view == atom.view &&
               std::equal(query.slots.begin() + other.begin, query.slots.begin() + other.end,
                          query.slots.begin() + atom.begin, query.slots.end());
    };
    if (std::none_of(query.atoms.begin(), query.atoms.end(), same)) query.atoms.push_back(atom);
}

void QueryCompiler::add_type(std::uint32_t variable, TypeId type, Query& query) {
    Query::Atom atom{0, static_cast<std::uint32_t>(query.slots.size()), 0};
    query.slots.push_back(variable);
    atom.end = atom.begin + 1;
    atom.view = database_.view(
        {database_.type_predicate(type), {0}, {own_[variable] ? types_[variable].index() : 0}});
    query.atoms.push_back(atom);
    joined_[variable] = true;
}

void QueryCompiler::add_absent(const Condition& literal, Query& query) {
    Query::Test test{Query::Test::Kind::absent, 0, 0, literal.predicate.index(), 0, 0};
    test.begin = static_cast<std::uint32_t>(query.terms.size());
    for (const Term term : literal.terms) query.terms.push_back(resolve(term));
    test.end = static_cast<std::uint32_t>(query.terms.size());
    query.tuple.resize(std::max(query.tuple.size(), literal.terms.size()));
    query.tests.push_back(test);
}

void QueryCompiler::add_check(const Condition& condition, Query& query) {
    Query::Check check;
    check.wanted = condition.kind != Kind::forall;
    // A compiler of its own: variables bound inside may be own ones out here.
    QueryCompiler inner(database_, types_);
    if (condition.kind == Kind::disjunction) {
        for (const Condition& child : condition.children)
            for (Query& part : inner.compile(child, {}, {})) check.alternatives.push_back(std::move(part));
    } else {
        const Condition& child = condition.children.front();
        check.alternatives = inner.compile(check.wanted ? child : negation(child), condition.variables, {});
    }
    query.checks.push_back(std::move(check));
}

void QueryCompiler::list_tests(Query& query, std::size_t variable_count) {
    std::vector<std::vector<std::uint32_t>> lists(variable_count);
    const auto note = [&](TermCode term, std::size_t test) {
        if (term < 0) return;
        std::vector<std::uint32_t>& list = lists[static_cast<std::size_t>(term)];
        if (list.empty() || list.back() != test) list.push_back(static_cast<std::uint32_t>(test));
    };
    for (std::size_t i = 0; i < query.tests.size(); ++i) {
        const Query::Test& test = query.tests[i];
        if (test.kind == Query::Test::Kind::absent) {
            for (std::uint32_t t = test.begin; t < test.end; ++t) note(query.terms[t], i);
        } else {
            note(test.left, i);
            note(test.right, i);
        }
    }
    query.tests_begin.assign(1, 0);
    for (const auto& list : lists) {
        query.tests_of.insert(query.tests_of.end(), list.begin(), list.end());
        query.tests_begin.push_back(static_cast<std::uint32_t>(query.tests_of.size()));
    }
}

void QueryCompiler::add(const Conjunct& conjunct, std::vector<std::uint32_t> own,
                        const std::vector<std::uint32_t>& distinguish, std::vector<Query>& result) {
    own.insert(own.end(), conjunct.exists.begin(), conjunct.exists.end());
    own_.assign(types_.size(), false);
    joined_.assign(types_.size(), false);
    substitution_.resize(types_.size());
    for (std::size_t v = 0; v < types_.size(); ++v) substitution_[v] = static_cast<TermCode>(v);
    for (const std::uint32_t variable : own) own_[variable] = true;
    possible_ = true;

    Query query;
    query.own = own;
    if (!solve_equations(conjunct, query)) return;
    for (const Condition* part : conjunct.parts) {
        if (part->kind == Kind::literal) {
            part->negated ? add_absent(*part, query) : add_atom(*part, query);
        } else if (part->kind == Kind::equality) {
            if (part->negated)
                add_comparison(Query::Test::Kind::unequal, resolve(part->terms[0]), resolve(part->terms[1]),
                               query);
        } else {
            add_check(*part, query);
        }
    }
    for (const std::uint32_t variable : own) {
        const TermCode value = resolve(Term::variable(variable));
        const TypeId type = types_[variable];
        if (value == static_cast<TermCode>(variable)) continue;
        query.copies.push_back({variable, value});
        if (value < 0)
            possible_ =
                possible_ && database_.task().types[type.index()].contains[static_cast<std::size_t>(~value)];
        else
            add_type(static_cast<std::uint32_t>(value), type, query);
    }
    for (const std::uint32_t variable : own)
        if (resolve(Term::variable(variable)) == static_cast<TermCode>(variable) && !joined_[variable])
            add_type(variable, types_[variable], query);
    if (!possible_) return;

    query.distinguish.assign(types_.size(), 0);
    for (const std::uint32_t variable : distinguish) {
        const TermCode value = resolve(Term::variable(variable));
        if (!is_own(value) || query.distinguish[static_cast<std::size_t>(value)] != 0) continue;
        query.distinguish[static_cast<std::size_t>(value)] = 1;
        ++query.distinguish_count;
    }
    list_tests(query, types_.size());
    for (std::uint32_t i = 0; i < query.atoms.size(); ++i) query.order.push_back(i);
    query.saved.resize(own.size());
    result.push_back(std::move(query));
}

}  // namespace praxis::lifted
