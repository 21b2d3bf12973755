#include "parser/check/conditions.hpp"

#include "parser/check/atoms.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;

class ConditionChecker {
  public:
    explicit ConditionChecker(ScopeBuilder& scope)
        : scope_(scope), context_(scope.context()), tree_(scope.tree()) {}

    Formula check(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::empty:
                return make(Connective::truth, node);
            case NodeKind::atom:
                return atom(node);
            case NodeKind::nested:
                refuse_nested(context_, tree_, node);
                break;
            case NodeKind::conjunction:
                return joined(index, Connective::conjunction, Connective::truth);
            case NodeKind::disjunction:
                context_.use(Feature::disjunctive_preconditions, tree_.where(node.head));
                return joined(index, Connective::disjunction, Connective::falsity);
            case NodeKind::negation:
                note_negation(node, tree_.nodes[index + 1]);
                return joined(index, Connective::negation, Connective::truth);
            case NodeKind::implication:
                context_.use(Feature::disjunctive_preconditions, tree_.where(node.head));
                return joined(index, Connective::implication, Connective::truth);
            case NodeKind::existential:
                context_.use(Feature::existential_preconditions, tree_.where(node.head));
                return quantified(index, Connective::existential);
            case NodeKind::universal:
                context_.use(Feature::universal_preconditions, tree_.where(node.head));
                return quantified(index, Connective::universal);
            case NodeKind::equality:
                return equality(index);
            case NodeKind::comparison:
                context_.reporter.unsupported(tree_.where(node), "numeric conditions");
                break;
            case NodeKind::when:
            case NodeKind::assignment:
            case NodeKind::arithmetic:
            case NodeKind::word:
                context_.reporter.error(tree_.where(node.head),
                                        quote(tree_.spelled(node.head)) + " cannot stand in a condition");
                break;
        }
        return make(Connective::truth, node);
    }

  private:
    Formula make(Connective kind, const Node& node) const {
        Formula formula;
        formula.kind = kind;
        formula.where = tree_.where(node);
        return formula;
    }

    void note_negation(const Node& node, const Node& child) {
        const bool of_equality = child.kind == NodeKind::equality;
        context_.use(of_equality ? Feature::equality : Feature::negative_preconditions,
                     tree_.where(node.head));
    }

    Formula joined(NodeIndex index, Connective kind, Connective kind_if_empty) {
        Formula formula = make(kind, tree_.nodes[index]);
        tree_.for_each_child(index, [&](NodeIndex child) { formula.children.push_back(check(child)); });
        if (formula.children.empty()) formula.kind = kind_if_empty;
        return formula;
    }

    Formula quantified(NodeIndex index, Connective kind) {
        Formula formula = make(kind, tree_.nodes[index]);
        const std::size_t outer = scope_.visible();
        formula.variables = scope_.bind_quantified(tree_.nodes[index].variables);
        formula.children.push_back(check(index + 1));
        scope_.unbind(outer);
        return formula;
    }

    Formula atom(const Node& node) {
        Formula formula = make(Connective::truth, node);
        const PredicateId predicate = resolve_predicate(context_, tree_, node);
        if (!predicate.valid()) return formula;
        std::optional<std::vector<Term>> terms = resolve_arguments(
            scope_, node, "predicate", context_.task.predicates[predicate.index()].parameters);
        if (!terms) return formula;
        formula.kind = Connective::atom;
        formula.predicate = predicate;
        formula.terms = std::move(*terms);
        return formula;
    }

    Formula equality(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        Formula formula = make(Connective::equality, node);
        bool numeric = false;
        bool object_fluent = false;
        tree_.for_each_child(index, [&](NodeIndex child) {
            const Node& operand = tree_.nodes[child];
            const bool is_list = operand.kind != NodeKind::word;
            object_fluent =
                object_fluent || (is_list && context_.object_functions[syntax::index(operand.head.symbol)]);
            numeric = numeric || is_list ||
                      (!context_.objects[operand.head.symbol].valid() &&
                       Rational::parse(tree_.spelled(operand.head)));
        });
        if (object_fluent || numeric) {
            context_.reporter.unsupported(tree_.where(node),
                                          object_fluent ? "object fluents" : "numeric conditions");
            return make(Connective::truth, node);
        }
        context_.use(Feature::equality, tree_.where(node));
        tree_.for_each_child(index, [&](NodeIndex child) {
            if (const std::optional<Term> term = scope_.resolve(tree_.nodes[child].head))
                formula.terms.push_back(*term);
        });
        return formula.terms.size() == 2 ? formula : make(Connective::truth, node);
    }

    ScopeBuilder& scope_;
    Context& context_;
    const syntax::Tree& tree_;
};

}  // namespace

Formula check_condition(ScopeBuilder& scope, NodeIndex index) {
    if (index == syntax::kNoNode) return {};
    return ConditionChecker(scope).check(index);
}

}  // namespace praxis::check
