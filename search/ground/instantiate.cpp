#include "search/ground/instantiate.hpp"

#include <algorithm>
#include <utility>

#include "search/ground/costs.hpp"
#include "search/ground/ground_condition.hpp"

namespace praxis::grounding {
namespace {

/// One operator may become this many because of disjunctions in its condition; effects and axioms likewise.
constexpr std::size_t kMostPerOperator = 16;
constexpr std::size_t kMostPerEffect = 16;
constexpr std::size_t kMostPerAxiom = 1024;

std::vector<std::int32_t> codes(const std::vector<Term>& terms) {
    std::vector<std::int32_t> result;
    for (Term term : terms)
        result.push_back(term.is_variable() ? static_cast<std::int32_t>(term.variable_index())
                                            : ~static_cast<std::int32_t>(term.object_id().index()));
    return result;
}

class Instantiation {
  public:
    Instantiation(const NormalTask& task, const Reached& reached, Relations& relations)
        : normal_(task), lifted_(*task.lifted), reached_(reached), relations_(relations) {}

    Instantiated run() {
        number_atoms();
        find_constants();
        ground_goal();
        task_.conditions.close();
        for (std::size_t s = 0; s < lifted_.schemas.size() && complete_; ++s) instantiate_schema(s);
        for (std::size_t a = 0; a < lifted_.axioms.size() && complete_; ++a) instantiate_axiom(a);
        return {std::move(task_), complete_ && !conditions_.stopped()};
    }

  private:
    struct PreparedEffect {
        bool add;
        bool plain;  ///< unconditional and without variables of its own
        RelationId relation;
        std::vector<std::int32_t> terms;
        JoinPlan plan;
        GroundableCondition condition;
    };
    struct SmallLiteral {
        bool negated;
        RelationId relation;
        std::vector<std::int32_t> terms;
    };

    void number_atoms() {
        AtomId next = 0;
        for (std::size_t p = 0; p < lifted_.predicates.size(); ++p) {
            task_.first_atom.push_back(next);
            if (reached_.exact[p]) continue;
            next += relations_[static_cast<RelationId>(p)].size();
            task_.derived.resize(next, lifted_.predicates[p].derived);
            task_.initial.resize(next, false);
            const Relation& initial = lifted_.initial_atoms[p];
            for (std::size_t i = 0; i < initial.count; ++i) {
                for (std::size_t c = 0; c < initial.arity; ++c) put(c, initial.tuple(i)[c].index());
                task_.initial[task_.first_atom[p] +
                              relations_[static_cast<RelationId>(p)].find(tuple_.data())] = true;
            }
        }
        task_.first_atom.push_back(next);
        task_.atom_count = next;
    }

    /// Initial atoms that no reached action deletes.
    void find_constants() {
        std::vector<bool> deletable(task_.atom_count, false);
        for (std::size_t s = 0; s < lifted_.schemas.size() && complete_; ++s) {
            const Schema& schema = lifted_.schemas[s];
            const std::vector<bool> bound = parameters_bound(schema.scope);
            binding_.resize(std::max(binding_.size(), schema.scope.variable_types.size()));
            for (const NormalEffect& effect : normal_.schemas[s].effects) {
                if (effect.effect->add) continue;
                const RelationId relation = effect.effect->predicate.index();
                const auto terms = codes(effect.effect->terms);
                const auto mark = [&] {
                    const Row row = find(relation, terms);
                    if (row != kNoRow) deletable[task_.first_atom[relation] + row] = true;
                    return relations_.tick();
                };
                const JoinPlan plan = effect_plan(effect, schema.scope.variable_types, bound);
                const TupleStore& actions = relations_[reached_.actions[s]];
                for (Row row = 0; row < actions.size() && complete_; ++row) {
                    std::copy_n(actions.row(row), actions.arity(), binding_.begin());
                    complete_ = effect.effect->variables.empty()
                                    ? mark()
                                    : plan.run(relations_, binding_.data(), kNoRow, mark);
                }
            }
        }
        task_.constant.resize(task_.atom_count);
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            task_.constant[atom] = task_.initial[atom] && !deletable[atom];
    }

    static std::vector<bool> parameters_bound(const Scope& scope) {
        std::vector<bool> bound(scope.variable_types.size(), false);
        std::fill_n(bound.begin(), scope.parameter_count, true);
        return bound;
    }

    JoinPlan effect_plan(const NormalEffect& effect, const std::vector<TypeId>& types,
                         const std::vector<bool>& bound) {
        const std::vector<BodyAtom> atom{{effect.effect->predicate.index(), effect.effect->terms, false}};
        return conditions_.generator_plan(conjuncts(effect.condition), false, atom, effect.effect->variables,
                                          types, bound);
    }

    void put(std::size_t column, Object object) {
        if (column >= tuple_.size()) tuple_.resize(column + 1);
        tuple_[column] = object;
    }

    Row find(RelationId relation, const std::vector<std::int32_t>& terms) {
        for (std::size_t c = 0; c < terms.size(); ++c)
            put(c, terms[c] >= 0 ? binding_[static_cast<std::size_t>(terms[c])]
                                 : static_cast<Object>(~terms[c]));
        return relations_[relation].find(tuple_.data());
    }

    void ground_goal() {
        const auto& types = lifted_.goal_scope.variable_types;
        binding_.resize(std::max(binding_.size(), types.size()));
        const auto goal = conditions_.prepare(normal_.goal, types, std::vector<bool>(types.size(), false));
        Disjunction result;
        conditions_.ground(goal, binding_.data(), 1, result);
        task_.goal_reachable = !result.empty();
        if (!result.empty()) task_.goal = std::move(result.front());
    }

    void instantiate_schema(std::size_t number) {
        const Schema& schema = lifted_.schemas[number];
        const NormalSchema& normal = normal_.schemas[number];
        const auto& types = schema.scope.variable_types;
        const std::vector<bool> bound = parameters_bound(schema.scope);
        binding_.resize(std::max(binding_.size(), types.size()));
        prepare_precondition(normal.precondition, types, bound);
        prepare_effects(normal, types, bound);
        CostEvaluator cost(lifted_, schema);
        const TupleStore& actions = relations_[reached_.actions[number]];
        for (Row row = 0; row < actions.size() && complete_; ++row) {
            complete_ = relations_.tick() && !conditions_.stopped();
            std::copy_n(actions.row(row), actions.arity(), binding_.begin());
            if (!ground_literals()) continue;
            if (!cost.evaluate(binding_.data())) continue;
            if (complex_.kind == Condition::Kind::truth) {
                add_operator(literals_, number, row, cost.value());
                continue;
            }
            conditions_.ground(complex_, binding_.data(), kMostPerOperator, alternatives_);
            for (const Conjunction& alternative : alternatives_) {
                Conjunction precondition = literals_;
                precondition.insert(precondition.end(), alternative.begin(), alternative.end());
                if (tidy(precondition)) add_operator(precondition, number, row, cost.value());
            }
        }
    }

    /// Literals over changing atoms go to `simple_`; what reachability has decided exactly is left out.
    void prepare_precondition(const Condition& precondition, const std::vector<TypeId>& types,
                              const std::vector<bool>& bound) {
        simple_.clear();
        std::vector<Condition> rest;
        for (const Condition& part : conjuncts(precondition)) {
            if (part.kind == Condition::Kind::literal) {
                if (!reached_.exact[part.predicate.index()])
                    simple_.push_back({part.negated, part.predicate.index(), codes(part.terms)});
            } else if (part.kind != Condition::Kind::equality) {
                rest.push_back(part);
            }
        }
        complex_ = conditions_.prepare(conjunction(std::move(rest)), types, bound);
    }

    void prepare_effects(const NormalSchema& normal, const std::vector<TypeId>& types,
                         const std::vector<bool>& bound) {
        effects_.clear();
        for (const bool add : {false, true}) {
            for (const NormalEffect& effect : normal.effects) {
                if (effect.effect->add != add) continue;
                PreparedEffect& made = effects_.emplace_back();
                made.add = add;
                made.plain =
                    effect.effect->variables.empty() && effect.condition.kind == Condition::Kind::truth;
                made.relation = effect.effect->predicate.index();
                made.terms = codes(effect.effect->terms);
                if (made.plain) continue;
                std::vector<bool> inner = bound;
                if (!effect.effect->variables.empty()) made.plan = effect_plan(effect, types, bound);
                for (std::uint32_t variable : effect.effect->variables) inner[variable] = true;
                made.condition = conditions_.prepare(effect.condition, types, inner);
            }
        }
    }

    bool ground_literals() {
        literals_.clear();
        for (const SmallLiteral& literal : simple_) {
            const Row row = find(literal.relation, literal.terms);
            if (row == kNoRow) {
                if (literal.negated) continue;
                return false;
            }
            const AtomId atom = task_.first_atom[literal.relation] + row;
            if (task_.constant[atom]) {
                if (literal.negated) return false;
                continue;
            }
            literals_.push_back(literal.negated ? negative(atom) : positive(atom));
        }
        return tidy(literals_);
    }

    void add_operator(const Conjunction& precondition, std::size_t schema, Row row, Rational cost) {
        operator_effects_.clear();
        for (const PreparedEffect& effect : effects_) {
            if (effect.plain) {
                add_effect(effect, 0);
            } else {
                const bool whole = effect.plan.run(relations_, binding_.data(), kNoRow, [&] {
                    add_conditional_effect(effect, precondition);
                    return relations_.tick();
                });
                complete_ = complete_ && whole;
            }
        }
        tidy_effects(precondition);
        if (operator_effects_.empty()) return;
        task_.preconditions.append(precondition);
        task_.effects.append(operator_effects_);
        task_.schemas.push_back(static_cast<std::uint32_t>(schema));
        task_.rows.push_back(row);
        if (lifted_.minimize_cost) task_.costs.push_back(cost);
    }

    void add_effect(const PreparedEffect& effect, std::uint32_t condition) {
        const Row row = find(effect.relation, effect.terms);
        if (row == kNoRow) return;
        const AtomId atom = task_.first_atom[effect.relation] + row;
        if (!task_.constant[atom])
            operator_effects_.push_back({effect.add ? positive(atom) : negative(atom), condition});
    }

    void add_conditional_effect(const PreparedEffect& effect, const Conjunction& precondition) {
        if (effect.condition.kind == Condition::Kind::truth) return add_effect(effect, 0);
        Disjunction cases;
        conditions_.ground(effect.condition, binding_.data(), kMostPerEffect, cases);
        for (Conjunction& one : cases) {
            const bool impossible = std::any_of(one.begin(), one.end(), [&](Literal literal) {
                return std::binary_search(precondition.begin(), precondition.end(), opposite(literal));
            });
            if (impossible) continue;
            std::erase_if(one, [&](Literal literal) {
                return std::binary_search(precondition.begin(), precondition.end(), literal);
            });
            std::uint32_t condition = 0;
            if (!one.empty()) {
                condition = static_cast<std::uint32_t>(task_.conditions.size());
                task_.conditions.append(one);
            }
            add_effect(effect, condition);
        }
    }

    /// Drops effects without effect: repeated ones, deletes of what is added for sure, what the precondition
    /// says already. Deletes come before adds.
    void tidy_effects(const Conjunction& precondition) {
        auto& effects = operator_effects_;
        sure_.clear();
        for (const PropositionEffect& effect : effects)
            if (effect.condition == 0) sure_.push_back({effect.literal, false});
        std::sort(sure_.begin(), sure_.end());
        const auto sure = [&](Literal literal) {
            const auto found = std::lower_bound(sure_.begin(), sure_.end(), std::pair(literal, false));
            return found != sure_.end() && found->first == literal ? &*found : nullptr;
        };
        const auto required = [&](Literal literal) {
            return std::binary_search(precondition.begin(), precondition.end(), literal);
        };
        touched_.clear();  // atoms that some remaining delete may make false
        const auto first_add =
            std::find_if(effects.begin(), effects.end(),
                         [](const PropositionEffect& effect) { return !is_negative(effect.literal); });
        for (auto effect = effects.begin(); effect != first_add; ++effect)
            if (!required(effect->literal) && sure(opposite(effect->literal)) == nullptr)
                touched_.push_back(opposite(effect->literal));
        std::sort(touched_.begin(), touched_.end());
        std::size_t kept = 0;
        for (const PropositionEffect& effect : effects) {
            const Literal literal = effect.literal;
            if (is_negative(literal) && sure(opposite(literal)) != nullptr) continue;
            if (required(literal) && !std::binary_search(touched_.begin(), touched_.end(), literal)) continue;
            if (auto* unconditional = sure(literal)) {
                if (effect.condition != 0 || std::exchange(unconditional->second, true)) continue;
            }
            effects[kept++] = effect;
        }
        effects.resize(kept);
    }

    void instantiate_axiom(std::size_t number) {
        const Axiom& axiom = lifted_.axioms[number];
        const RelationId relation = axiom.predicate.index();
        if (reached_.exact[relation]) return;
        const auto& types = axiom.scope.variable_types;
        binding_.resize(std::max(binding_.size(), types.size()));
        const auto body = conditions_.prepare(normal_.axioms[number], types, parameters_bound(axiom.scope));
        const TupleStore& heads = relations_[relation];
        for (Row row = 0; row < heads.size() && complete_; ++row) {
            complete_ = relations_.tick() && !conditions_.stopped();
            std::copy_n(heads.row(row), heads.arity(), binding_.begin());
            bool typed = true;
            for (std::uint32_t c = 0; c < heads.arity(); ++c)
                typed = typed && lifted_.types[types[c].index()].contains[binding_[c]];
            if (!typed) continue;
            conditions_.ground(body, binding_.data(), kMostPerAxiom, alternatives_);
            for (const Conjunction& alternative : alternatives_) {
                task_.heads.push_back(task_.first_atom[relation] + row);
                task_.bodies.append(alternative);
            }
        }
    }

    const NormalTask& normal_;
    const LiftedTask& lifted_;
    const Reached& reached_;
    Relations& relations_;
    PropositionTask task_;
    ConditionGrounder conditions_{relations_, reached_.exact, task_};
    bool complete_ = true;

    std::vector<SmallLiteral> simple_;
    GroundableCondition complex_;
    std::vector<PreparedEffect> effects_;

    std::vector<Object> binding_;
    std::vector<Object> tuple_;
    Conjunction literals_;
    Disjunction alternatives_;
    std::vector<PropositionEffect> operator_effects_;
    std::vector<std::pair<Literal, bool>> sure_;  ///< unconditional effects, and whether met
    std::vector<Literal> touched_;
};

}  // namespace

Instantiated instantiate(const NormalTask& task, const Reached& reached, Relations& relations) {
    return Instantiation(task, reached, relations).run();
}

}  // namespace praxis::grounding
