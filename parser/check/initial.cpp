#include "parser/check/initial.hpp"

#include "parser/check/atoms.hpp"
#include "parser/check/contingent/refuse.hpp"
#include "parser/check/contingent/uncertainty.hpp"
#include "parser/check/ground.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::Word;

class InitialStateChecker {
  public:
    InitialStateChecker(Context& context, const syntax::Tree& problem)
        : context_(context), tree_(problem), ground_(context, problem) {
        LiftedTask& task = context.task;
        task.initial_atoms.resize(task.predicates.size());
        for (std::size_t i = 0; i < task.predicates.size(); ++i) {
            task.initial_atoms[i].arity = static_cast<std::uint32_t>(task.predicates[i].parameters.size());
            atoms_.emplace_back(task.initial_atoms[i]);
        }
        task.initial_values.resize(task.functions.size());
        for (std::size_t i = 0; i < task.functions.size(); ++i) {
            task.initial_values[i].tuples.arity =
                static_cast<std::uint32_t>(task.functions[i].parameters.size());
            values_.emplace_back(task.initial_values[i].tuples);
        }
    }

    std::vector<TupleIndex> check() {
        for (const NodeIndex index : tree_.init) check(index);
        for (const Node* node : negated_) check_negated(*node);
        return std::move(atoms_);
    }

  private:
    void check(NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::empty:
                break;
            case NodeKind::atom:
                if (!uncertain(node)) add_atom(node);
                break;
            case NodeKind::equality:
                add_value(index);
                break;
            case NodeKind::nested:
            case NodeKind::disjunction:
                if (!uncertain(node)) refuse_nested(context_, tree_, node);
                break;
            case NodeKind::conjunction:
                tree_.for_each_child(index, [&](NodeIndex child) { check(child); });
                break;
            case NodeKind::negation:
                if (tree_.nodes[index + 1].kind == NodeKind::atom) {
                    negated_.push_back(&tree_.nodes[index + 1]);
                    break;
                }
                [[fallthrough]];
            default:
                context_.reporter.error(tree_.where(node.head), quote(tree_.spelled(node.head)) +
                                                                    " cannot stand in the initial state");
                break;
        }
    }

    /// What is said about uncertain atoms is read by check_uncertainty; a classical task cannot have it.
    bool uncertain(const Node& node) {
        if (!states_uncertainty(context_, node)) return false;
        if (context_.contingent == nullptr) {
            context_.reporter.unsupported(tree_.where(node.head), "uncertain initial states",
                                          std::string(kBeliefHint));
        }
        return true;
    }

    void add_atom(const Node& node) {
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return;
        const Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.derived) {
            context_.reporter.error(tree_.where(node), "the derived predicate " + quote(predicate.name) +
                                                           " cannot stand in the initial state");
        }
        if (ground_.resolve(node, "predicate", predicate.parameters))
            atoms_[id.index()].insert(ground_.tuple());
    }

    void check_negated(const Node& node) {
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid() ||
            !ground_.resolve(node, "predicate", context_.task.predicates[id.index()].parameters))
            return;
        if (atoms_[id.index()].find(ground_.tuple()) == TupleIndex::kNone) return;
        context_.reporter.error(tree_.where(node), "the initial state contains this atom and its negation");
    }

    void add_value(NodeIndex index) {
        const Node& function_node = tree_.nodes[index + 1];
        const Node& value_node = tree_.nodes[function_node.end];
        if (function_node.kind == NodeKind::word && !context_.functions[function_node.head.symbol].valid()) {
            context_.reporter.error(tree_.where(function_node),
                                    "expected a function, found " + quote(tree_.spelled(function_node.head)));
            return;
        }
        if (function_node.kind == NodeKind::nested) return refuse_nested(context_, tree_, function_node);
        if (function_node.kind != NodeKind::atom && function_node.kind != NodeKind::word) {
            context_.reporter.error(tree_.where(function_node), "expected a function");
            return;
        }
        const FunctionId id = resolve_function(context_, tree_, function_node);
        if (!id.valid()) return;
        std::optional<Rational> value;
        if (value_node.kind == NodeKind::word) value = Rational::parse(tree_.spelled(value_node.head));
        if (!value) {
            context_.reporter.error(tree_.where(value_node), "expected a number");
            return;
        }
        if (ground_.resolve(function_node, "function", context_.task.functions[id.index()].parameters)) {
            set_value(id, *value, value_node);
        }
    }

    void set_value(FunctionId id, Rational value, const Node& value_node) {
        std::vector<Rational>& values = context_.task.initial_values[id.index()].values;
        const std::size_t number = values_[id.index()].insert(ground_.tuple());
        if (number == values.size()) {
            values.push_back(value);
        } else if (values[number] != value) {
            context_.reporter.error(tree_.where(value_node), "a second value for the same function",
                                    "it was " + values[number].to_string() + " before");
        }
    }

    Context& context_;
    const syntax::Tree& tree_;
    GroundArguments ground_;
    std::vector<TupleIndex> atoms_;   ///< by predicate
    std::vector<TupleIndex> values_;  ///< by function
    std::vector<const Node*> negated_;
};

}  // namespace

std::vector<TupleIndex> check_initial_state(Context& context, const syntax::Tree& problem) {
    return InitialStateChecker(context, problem).check();
}

}  // namespace praxis::check
