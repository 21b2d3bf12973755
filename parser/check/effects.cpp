#include "parser/check/effects.hpp"

#include "parser/check/atoms.hpp"
#include "parser/check/costs.hpp"
#include "parser/check/guards.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

class EffectChecker {
  public:
    EffectChecker(ScopeBuilder& scope, Schema& schema)
        : scope_(scope), context_(scope.context()), tree_(scope.tree()), schema_(schema), guards_(scope) {}

    void check(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::empty:
                break;
            case NodeKind::atom:
                add(node, true);
                break;
            case NodeKind::nested:
                nested(index);
                break;
            case NodeKind::conjunction:
                tree_.for_each_child(index, [&](NodeIndex child) { check(child); });
                break;
            case NodeKind::negation:
                remove(tree_.nodes[index + 1]);
                break;
            case NodeKind::universal:
                context_.use(Feature::conditional_effects, tree_.where(node.head));
                guards_.universal(index, [this](NodeIndex body) { check(body); });
                break;
            case NodeKind::when:
                context_.use(Feature::conditional_effects, tree_.where(node.head));
                guards_.conditional(index, [this](NodeIndex body) { check(body); });
                break;
            case NodeKind::assignment:
                assignment(index);
                break;
            case NodeKind::disjunction:
            case NodeKind::implication:
            case NodeKind::existential:
            case NodeKind::equality:
            case NodeKind::comparison:
            case NodeKind::arithmetic:
            case NodeKind::word:
                context_.reporter.error(tree_.where(node.head),
                                        quote(tree_.spelled(node.head)) + " cannot stand in an effect");
                break;
        }
    }

  private:
    void remove(const Node& node) {
        if (node.kind == NodeKind::atom) {
            add(node, false);
        } else if (node.kind == NodeKind::nested) {
            refuse_nested(context_, tree_, node);
        } else {
            context_.reporter.error(tree_.where(node), "only an atom can be deleted");
        }
    }

    void add(const Node& node, bool adds) {
        std::optional<Effect> effect = single(node);
        if (!effect) return;
        effect->add = adds;
        schema_.effects.push_back(std::move(*effect));
    }

    std::optional<Effect> single(const Node& node) {
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return std::nullopt;
        Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.derived) {
            context_.reporter.error(tree_.where(node),
                                    "an effect on the derived predicate " + quote(predicate.name));
        }
        std::optional<std::vector<Term>> terms =
            resolve_arguments(scope_, node, "predicate", predicate.parameters);
        if (!terms) return std::nullopt;
        predicate.fluent = true;
        Effect effect;
        effect.variables = guards_.variables();
        effect.condition = guards_.condition(tree_.where(node));
        effect.predicate = id;
        effect.terms = std::move(*terms);
        effect.where = tree_.where(node);
        return effect;
    }

    /// `(unknown (p ?x))` in a contingent task; otherwise a mistake.
    void nested(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        const bool forgets = context_.contingent != nullptr && node.head.symbol == Word::unknown &&
                             tree_.own_words(index).empty() && !context_.predicates[node.head.symbol].valid();
        if (!forgets) return refuse_nested(context_, tree_, node);
        tree_.for_each_child(index, [&](NodeIndex child) {
            const Node& atom = tree_.nodes[child];
            if (atom.kind != NodeKind::atom) {
                context_.reporter.error(tree_.where(atom), "only an atom can become unknown");
            } else if (std::optional<Effect> effect = single(atom)) {
                context_.contingent->sensing.back().forgotten.push_back(std::move(*effect));
            }
        });
    }

    void assignment(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        const Node& target = tree_.nodes[index + 1];
        if (target.kind != NodeKind::atom) {
            context_.reporter.error(tree_.where(target), "expected a function");
            return;
        }
        const FunctionId function = resolve_function(context_, tree_, target);
        if (!function.valid()) return;
        if (target.head.symbol != Word::total_cost || node.head.symbol != Word::increase) {
            context_.reporter.unsupported(tree_.where(node),
                                          "numeric effects other than (increase (total-cost) ...)");
            return;
        }
        if (!guards_.empty()) {
            context_.reporter.unsupported(tree_.where(node), "conditional and universal costs");
            return;
        }
        resolve_arguments(scope_, target, "function", context_.task.functions[function.index()].parameters);
        if (std::optional<Expression> cost = check_cost(scope_, target.end)) add_cost(std::move(*cost));
    }

    void add_cost(Expression cost) {
        if (!schema_.cost) {
            schema_.cost = std::move(cost);
            return;
        }
        if (schema_.cost->kind == Expression::Kind::add) {
            schema_.cost->children.push_back(std::move(cost));
            return;
        }
        Expression sum;
        sum.kind = Expression::Kind::add;
        sum.where = cost.where;
        sum.children.push_back(std::move(*schema_.cost));
        sum.children.push_back(std::move(cost));
        schema_.cost = std::move(sum);
    }

    ScopeBuilder& scope_;
    Context& context_;
    const syntax::Tree& tree_;
    Schema& schema_;
    Guards guards_;
};

}  // namespace

void check_effects(ScopeBuilder& scope, NodeIndex index, Schema& schema) {
    if (index != syntax::kNoNode) EffectChecker(scope, schema).check(index);
}

}  // namespace praxis::check
