#include "parser/check/costs.hpp"

#include "parser/check/atoms.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

Expression::Kind kind_of(const Node& node, std::size_t operands) {
    if (node.head.symbol == Word::plus) return Expression::Kind::add;
    if (node.head.symbol == Word::times) return Expression::Kind::multiply;
    if (node.head.symbol == Word::divide) return Expression::Kind::divide;
    return operands == 1 ? Expression::Kind::negate : Expression::Kind::subtract;
}

std::optional<Expression> function_value(ScopeBuilder& scope, const Node& node) {
    Context& context = scope.context();
    const syntax::Tree& tree = scope.tree();
    const FunctionId function = resolve_function(context, tree, node);
    if (!function.valid()) return std::nullopt;
    if (node.head.symbol == Word::total_cost) {
        context.reporter.unsupported(tree.where(node.head), "costs that depend on the total cost");
        return std::nullopt;
    }
    std::optional<std::vector<Term>> terms =
        resolve_arguments(scope, node, "function", context.task.functions[function.index()].parameters);
    if (!terms) return std::nullopt;
    Expression expression;
    expression.kind = Expression::Kind::function;
    expression.function = function;
    expression.terms = std::move(*terms);
    expression.where = tree.where(node);
    return expression;
}

std::optional<Expression> word_value(ScopeBuilder& scope, const Node& node) {
    Context& context = scope.context();
    const syntax::Tree& tree = scope.tree();
    const std::string_view spelled = tree.spelled(node.head);
    if (const std::optional<Rational> number = Rational::parse(spelled)) {
        Expression expression;
        expression.value = *number;
        expression.where = tree.where(node);
        return expression;
    }
    if (context.functions[node.head.symbol].valid()) return function_value(scope, node);
    context.reporter.error(tree.where(node), "expected a number or a function, found " + quote(spelled),
                           spelled.find_first_not_of("+-.0123456789e") == std::string_view::npos
                               ? "a number too large or too long"
                               : "");
    return std::nullopt;
}

std::optional<Expression> arithmetic_value(ScopeBuilder& scope, NodeIndex index) {
    Context& context = scope.context();
    const syntax::Tree& tree = scope.tree();
    const Node& node = tree.nodes[index];
    Expression expression;
    expression.where = tree.where(node);
    bool right = true;
    std::size_t operands = 0;
    tree.for_each_child(index, [&](NodeIndex child) {
        ++operands;
        if (std::optional<Expression> operand = check_cost(scope, child)) {
            expression.children.push_back(std::move(*operand));
        } else {
            right = false;
        }
    });
    expression.kind = kind_of(node, operands);
    const bool many = node.head.symbol == Word::plus || node.head.symbol == Word::times;
    const bool enough = many ? operands >= 1 : operands == 2 || expression.kind == Expression::Kind::negate;
    if (!enough) {
        context.reporter.error(tree.where(node), quote(tree.spelled(node.head)) + " takes " +
                                                     (many ? "at least one operand" : "two operands") +
                                                     ", not " + std::to_string(operands));
    }
    if (!right || !enough) return std::nullopt;
    return expression;
}

}  // namespace

std::optional<Expression> check_cost(ScopeBuilder& scope, NodeIndex index) {
    const Node& node = scope.tree().nodes[index];
    switch (node.kind) {
        case NodeKind::word:
            return word_value(scope, node);
        case NodeKind::atom:
            return function_value(scope, node);
        case NodeKind::arithmetic:
            return arithmetic_value(scope, index);
        case NodeKind::nested:
            refuse_nested(scope.context(), scope.tree(), node);
            break;
        default:
            scope.context().reporter.error(scope.tree().where(node), "expected a number or a function");
            break;
    }
    return std::nullopt;
}

}  // namespace praxis::check
