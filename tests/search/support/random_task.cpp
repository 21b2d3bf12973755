#include "tests/search/support/random_task.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <utility>

namespace praxis::test {

namespace {

constexpr std::size_t kBasic = 5;
constexpr std::size_t kDerived = 3;

class Maker {
  public:
    explicit Maker(std::uint32_t seed) : random_(seed) {}

    RandomTask make() {
        make_types();
        make_predicates();
        for (std::size_t i = 0; i < 3; ++i) make_schema("act" + std::to_string(i));
        for (std::size_t i = 0; i < kDerived + 2; ++i) {
            make_axiom(i < kDerived ? kBasic + i : kBasic + below(kDerived));
        }
        scope_ = &task_.goal_scope;
        usable_ = kBasic + kDerived;
        std::vector<std::uint32_t> none;
        task_.goal = formula(3, none, 0);
        Plan plan = make_plan();
        return {std::move(task_), std::move(plan)};
    }

  private:
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    bool chance(double p) { return std::bernoulli_distribution(p)(random_); }

    void make_types() {
        const std::size_t objects = 1 + below(4);
        task_.types.resize(3);
        for (std::size_t t = 0; t < 3; ++t) {
            task_.types[t].name = "t" + std::to_string(t);
            task_.types[t].contains.resize(objects, false);
        }
        for (std::size_t o = 0; o < objects; ++o) {
            const std::size_t type = below(3);
            task_.objects.push_back({"o" + std::to_string(o), TypeId(type), {}});
            for (const std::size_t t : {std::size_t{0}, type}) {
                if (task_.types[t].contains[o]) continue;
                task_.types[t].contains[o] = true;
                task_.types[t].objects.emplace_back(o);
            }
        }
    }

    void make_predicates() {
        for (std::size_t p = 0; p < kBasic + kDerived; ++p) {
            Predicate predicate;
            predicate.name = "p" + std::to_string(p);
            predicate.parameters.resize(below(3), TypeId(0));
            predicate.derived = p >= kBasic;
            task_.predicates.push_back(std::move(predicate));
            Relation relation;
            relation.arity = static_cast<std::uint32_t>(task_.predicates[p].parameters.size());
            std::size_t tuples = 1;
            for (std::uint32_t i = 0; i < relation.arity; ++i) tuples *= task_.objects.size();
            for (std::size_t code = 0; p < kBasic && code < tuples; ++code) {
                if (chance(0.5)) continue;
                for (std::size_t rest = code, i = 0; i < relation.arity; ++i, rest /= task_.objects.size()) {
                    relation.arguments.emplace_back(rest % task_.objects.size());
                }
                ++relation.count;
            }
            task_.initial_atoms.push_back(std::move(relation));
        }
    }

    std::uint32_t add_variable(std::size_t type) {
        scope_->variable_types.emplace_back(type);
        scope_->variable_names.push_back("?v" + std::to_string(scope_->variable_names.size()));
        return static_cast<std::uint32_t>(scope_->variable_types.size() - 1);
    }

    std::vector<Term> terms(std::size_t count, const std::vector<std::uint32_t>& visible) {
        std::vector<Term> result;
        for (std::size_t i = 0; i < count; ++i) {
            const bool variable = !visible.empty() && chance(0.85);
            result.push_back(variable ? Term::variable(visible[below(visible.size())])
                                      : Term::object(ObjectId(below(task_.objects.size()))));
        }
        return result;
    }

    /// `depth` bounds the size. Predicates from `usable_` on may not occur; `negations` counts those around.
    Formula formula(std::size_t depth, const std::vector<std::uint32_t>& visible, std::size_t negations) {
        static constexpr Connective kInner[] = {Connective::negation,    Connective::conjunction,
                                                Connective::conjunction, Connective::disjunction,
                                                Connective::implication, Connective::existential,
                                                Connective::existential, Connective::universal};
        Formula result;
        result.kind = depth == 0 || chance(0.2) ? leaf() : kInner[below(8)];
        switch (result.kind) {
            case Connective::atom: {
                // An axiom may use its own predicate, but not under a negation.
                std::size_t limit = usable_;
                if (negations % 2 != 0 && limit > kBasic && own_) --limit;
                result.predicate = PredicateId(below(limit));
                result.terms = terms(task_.predicates[result.predicate.index()].parameters.size(), visible);
                break;
            }
            case Connective::equality:
                result.terms = terms(2, visible);
                break;
            case Connective::negation:
                result.children.push_back(formula(depth - 1, visible, negations + 1));
                break;
            case Connective::implication:
                result.children.push_back(formula(depth - 1, visible, negations + 1));
                result.children.push_back(formula(depth - 1, visible, negations));
                break;
            case Connective::conjunction:
            case Connective::disjunction:
                for (std::size_t i = below(4); i > 0; --i) {
                    result.children.push_back(formula(depth - 1, visible, negations));
                }
                break;
            case Connective::existential:
            case Connective::universal: {
                std::vector<std::uint32_t> inside = visible;
                for (std::size_t i = 1 + below(2); i > 0; --i) {
                    result.variables.push_back(add_variable(below(3)));
                    inside.push_back(result.variables.back());
                }
                result.children.push_back(formula(depth - 1, inside, negations));
                break;
            }
            default:
                break;
        }
        return result;
    }

    Connective leaf() {
        if (chance(0.8)) return Connective::atom;
        if (chance(0.7)) return Connective::equality;
        return chance(0.7) ? Connective::truth : Connective::falsity;
    }

    void make_schema(std::string name) {
        Schema schema;
        schema.name = std::move(name);
        scope_ = &schema.scope;
        own_ = false;
        usable_ = kBasic + kDerived;
        std::vector<std::uint32_t> parameters;
        for (std::size_t i = below(3); i > 0; --i) parameters.push_back(add_variable(below(3)));
        schema.scope.parameter_count = static_cast<std::uint32_t>(parameters.size());
        schema.precondition = formula(chance(0.5) ? 1 : 3, parameters, 0);
        for (std::size_t i = 1 + below(3); i > 0; --i) {
            Effect effect;
            std::vector<std::uint32_t> visible = parameters;
            for (std::size_t v = below(3); v > 0; --v) {
                effect.variables.push_back(add_variable(below(3)));
                visible.push_back(effect.variables.back());
            }
            if (chance(0.6)) effect.condition = formula(2, visible, 0);
            effect.add = chance(0.5);
            effect.predicate = PredicateId(below(kBasic));
            task_.predicates[effect.predicate.index()].fluent = true;
            effect.terms = terms(task_.predicates[effect.predicate.index()].parameters.size(), visible);
            schema.effects.push_back(std::move(effect));
        }
        task_.schemas.push_back(std::move(schema));
    }

    void make_axiom(std::size_t predicate) {
        Axiom axiom;
        axiom.predicate = PredicateId(predicate);
        scope_ = &axiom.scope;
        own_ = true;
        usable_ = predicate + 1;
        std::vector<std::uint32_t> parameters;
        for (std::size_t i = 0; i < task_.predicates[predicate].parameters.size(); ++i) {
            parameters.push_back(add_variable(chance(0.8) ? 0 : below(3)));
        }
        axiom.scope.parameter_count = static_cast<std::uint32_t>(parameters.size());
        axiom.body = formula(3, parameters, 0);
        own_ = false;
        task_.axioms.push_back(std::move(axiom));
    }

    Plan make_plan() {
        Plan plan;
        for (std::size_t i = below(6); i > 0; --i) {
            PlanStep step;
            step.schema = SchemaId(below(task_.schemas.size()));
            const Scope& scope = task_.schemas[step.schema.index()].scope;
            for (std::uint32_t p = 0; p < scope.parameter_count; ++p) {
                const std::vector<ObjectId>& objects = task_.types[scope.variable_types[p].index()].objects;
                if (objects.empty()) break;
                step.arguments.push_back(objects[below(objects.size())]);
            }
            if (step.arguments.size() == scope.parameter_count) plan.steps.push_back(std::move(step));
        }
        return plan;
    }

    std::mt19937 random_;
    LiftedTask task_;
    Scope* scope_ = nullptr;
    std::size_t usable_ = 0;
    bool own_ = false;
};

}  // namespace

RandomTask random_task(std::uint32_t seed) {
    return Maker(seed).make();
}

}  // namespace praxis::test
