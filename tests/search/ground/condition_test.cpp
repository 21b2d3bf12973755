// Normal forms against the formulas they came from.
#include "search/ground/condition.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

#include "tests/search/support/naive_semantics.hpp"
#include "tests/search/support/random_task.hpp"

namespace praxis::grounding {
namespace {

using Kind = Condition::Kind;

Formula formula_of(const Condition& condition) {
    static constexpr Connective kConnectives[] = {
        Connective::truth,       Connective::falsity,     Connective::atom,        Connective::equality,
        Connective::conjunction, Connective::disjunction, Connective::existential, Connective::universal};
    Formula result;
    result.kind = kConnectives[static_cast<std::size_t>(condition.kind)];
    result.predicate = condition.predicate;
    result.terms = condition.terms;
    result.variables = condition.variables;
    for (const Condition& child : condition.children) result.children.push_back(formula_of(child));
    if (!condition.negated) return result;
    Formula negation;
    negation.kind = Connective::negation;
    negation.children.push_back(std::move(result));
    return negation;
}

/// What the type promises, beyond meaning the same.
void check_form(const Condition& condition, bool top = true) {
    const bool leaf = condition.kind == Kind::literal || condition.kind == Kind::equality;
    RC_ASSERT(leaf || !condition.negated);
    const bool constant = condition.kind == Kind::truth || condition.kind == Kind::falsity;
    RC_ASSERT(top || !constant);
    const bool junction = condition.kind == Kind::conjunction || condition.kind == Kind::disjunction;
    RC_ASSERT(!junction || condition.children.size() > 1);
    if (condition.kind == Kind::equality)
        RC_ASSERT(condition.terms[0] != condition.terms[1] &&
                  (condition.terms[0].is_variable() || condition.terms[1].is_variable()));
    for (const Condition& child : condition.children) {
        RC_ASSERT(!junction || child.kind != condition.kind);
        // A quantified constant stays: its type may be empty.
        check_form(child, !junction);
    }
}

void check_formula(const Formula& formula, const Scope& scope, const LiftedTask& task, std::mt19937& random) {
    const test::NaiveSemantics semantics(task);
    const Condition positive = normalise(formula);
    const Condition negative = normalise(formula, true);
    check_form(positive);
    check_form(negative);
    const Formula yes = formula_of(positive);
    const Formula no = formula_of(negative);
    for (int i = 0; i < 12; ++i) {
        test::NaiveSemantics::State state(semantics.atom_count());
        for (std::size_t a = 0; a < state.size(); ++a) state[a] = random() % 2 == 0;
        test::NaiveSemantics::Tuple values(scope.variable_types.size());
        for (std::size_t v = 0; v < values.size(); ++v) {
            const auto& objects = task.types[scope.variable_types[v].index()].objects;
            if (objects.empty() && v < scope.parameter_count) return;
            if (!objects.empty()) values[v] = objects[random() % objects.size()].index();
        }
        const auto truth = [&](const Formula& f) {
            auto copy = values;
            return semantics.holds(f, scope, copy, state);
        };
        RC_ASSERT(truth(yes) == truth(formula));
        RC_ASSERT(truth(no) != truth(formula));
    }
    for (const std::uint32_t variable : free_variables(positive)) RC_ASSERT(variable < scope.parameter_count);
}

TEST(Condition, MeansWhatTheFormulaMeans) {
    std::size_t quantified = 0, formulas = 0;
    EXPECT_TRUE(rc::check([&] {
        const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        std::mt19937 random(seed);
        const test::RandomTask made = test::random_task(seed);
        const auto check = [&](const Formula& formula, const Scope& scope) {
            ++formulas;
            quantified += scope.variable_types.size() > scope.parameter_count;
            check_formula(formula, scope, made.task, random);
        };
        for (const Schema& schema : made.task.schemas) check(schema.precondition, schema.scope);
        for (const Axiom& axiom : made.task.axioms) check(axiom.body, axiom.scope);
        check(made.task.goal, made.task.goal_scope);
    }));
    EXPECT_GT(quantified * 4, formulas);
}

Formula atom(std::uint32_t predicate, std::vector<Term> terms) {
    Formula result;
    result.kind = Connective::atom;
    result.predicate = PredicateId(predicate);
    result.terms = std::move(terms);
    return result;
}

Formula compound(Connective kind, std::vector<Formula> children, std::vector<std::uint32_t> variables = {}) {
    Formula result;
    result.kind = kind;
    result.children = std::move(children);
    result.variables = std::move(variables);
    return result;
}

TEST(Condition, QuantifiersSplit) {
    const Term z = Term::variable(1);
    const Formula either = compound(Connective::disjunction, {atom(1, {z}), atom(2, {z})});
    const Formula mixed = compound(Connective::conjunction, {atom(0, {z}), either});
    const Condition some = normalise(compound(Connective::existential, {mixed}, {1}));
    ASSERT_EQ(some.kind, Kind::disjunction);
    ASSERT_EQ(some.children.size(), 2U);
    EXPECT_EQ(some.children[0].kind, Kind::exists);
    EXPECT_EQ(some.children[0].children[0].kind, Kind::conjunction);
    const Condition all = normalise(compound(Connective::universal, {mixed}, {1}));
    EXPECT_EQ(all.kind, Kind::conjunction);
    EXPECT_EQ(all.children.size(), 2U);
}

TEST(Condition, ProductsAreMultipliedOutOnlyWhileSmall) {
    const Term z = Term::variable(0);
    const auto product = [&](std::uint32_t factors) {
        std::vector<Formula> parts;
        for (std::uint32_t i = 0; i < factors; ++i)
            parts.push_back(compound(Connective::disjunction, {atom(2 * i, {z}), atom(2 * i + 1, {z})}));
        return normalise(
            compound(Connective::existential, {compound(Connective::conjunction, std::move(parts))}, {0}));
    };
    EXPECT_EQ(product(3).kind, Kind::disjunction);
    EXPECT_EQ(product(3).children.size(), 8U);
    EXPECT_EQ(product(4).kind, Kind::exists);
    EXPECT_EQ(product(60).kind, Kind::exists);
}

TEST(Condition, EqualitiesAreDecided) {
    Formula same = atom(0, {Term::variable(3), Term::variable(3)});
    same.kind = Connective::equality;
    EXPECT_EQ(normalise(same).kind, Kind::truth);
    EXPECT_EQ(normalise(same, true).kind, Kind::falsity);
    same.terms = {Term::object(ObjectId(0)), Term::object(ObjectId(1))};
    EXPECT_EQ(normalise(same).kind, Kind::falsity);
    same.terms = {Term::variable(0), Term::object(ObjectId(1))};
    EXPECT_EQ(normalise(same, true).kind, Kind::equality);
    EXPECT_TRUE(normalise(same, true).negated);
}

}  // namespace
}  // namespace praxis::grounding
