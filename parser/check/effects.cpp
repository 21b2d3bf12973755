#include "parser/check/effects.hpp"

#include "parser/check/atoms.hpp"
#include "parser/check/conditions.hpp"
#include "parser/check/costs.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

constexpr std::size_t kMaxCopiedFormulas = 5'000'000;

std::size_t count_formulas(const Formula& formula) {
    std::size_t count = 1;
    for (const Formula& child : formula.children) count += count_formulas(child);
    return count;
}

class EffectChecker {
  public:
    EffectChecker(ScopeBuilder& scope, Schema& schema)
        : scope_(scope), context_(scope.context()), tree_(scope.tree()), schema_(schema) {}

    void check(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::empty:
                break;
            case NodeKind::atom:
                add(node, true);
                break;
            case NodeKind::nested:
                refuse_nested(context_, tree_, node);
                break;
            case NodeKind::conjunction:
                tree_.for_each_child(index, [&](NodeIndex child) { check(child); });
                break;
            case NodeKind::negation:
                remove(tree_.nodes[index + 1]);
                break;
            case NodeKind::universal:
                universal(index);
                break;
            case NodeKind::when:
                conditional(index);
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
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return;
        Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.derived) {
            context_.reporter.error(tree_.where(node),
                                    "an effect on the derived predicate " + quote(predicate.name));
        }
        std::optional<std::vector<Term>> terms =
            resolve_arguments(scope_, node, "predicate", predicate.parameters);
        if (!terms) return;
        predicate.fluent = true;
        Effect effect;
        effect.variables = variables_;
        effect.condition = joined_condition(node);
        effect.add = adds;
        effect.predicate = id;
        effect.terms = std::move(*terms);
        effect.where = tree_.where(node);
        schema_.effects.push_back(std::move(effect));
    }

    Formula joined_condition(const Node& node) {
        if (conditions_.empty()) {
            Formula truth;
            truth.where = tree_.where(node);
            return truth;
        }
        context_.copied_formulas += condition_size_;
        if (context_.copied_formulas > kMaxCopiedFormulas) {
            if (!too_large_) context_.reporter.error(tree_.where(node), "conditional effects too large");
            too_large_ = true;
            return {};
        }
        if (conditions_.size() == 1) return conditions_.front();
        Formula all;
        all.kind = Connective::conjunction;
        all.children = conditions_;
        all.where = conditions_.back().where;
        return all;
    }

    void universal(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        context_.use(Feature::conditional_effects, tree_.where(node.head));
        const std::size_t outer = scope_.visible();
        const std::size_t outer_variables = variables_.size();
        const std::vector<std::uint32_t> bound = scope_.bind_quantified(node.variables);
        variables_.insert(variables_.end(), bound.begin(), bound.end());
        check(index + 1);
        variables_.resize(outer_variables);
        scope_.unbind(outer);
    }

    void conditional(NodeIndex index) {
        context_.use(Feature::conditional_effects, tree_.where(tree_.nodes[index].head));
        conditions_.push_back(check_condition(scope_, index + 1));
        const std::size_t size = count_formulas(conditions_.back());
        condition_size_ += size;
        check(tree_.nodes[index + 1].end);
        condition_size_ -= size;
        conditions_.pop_back();
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
        if (!conditions_.empty() || !variables_.empty()) {
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
    std::vector<std::uint32_t> variables_;
    std::vector<Formula> conditions_;
    std::size_t condition_size_ = 0;
    bool too_large_ = false;
};

}  // namespace

void check_effects(ScopeBuilder& scope, NodeIndex index, Schema& schema) {
    if (index != syntax::kNoNode) EffectChecker(scope, schema).check(index);
}

}  // namespace praxis::check
