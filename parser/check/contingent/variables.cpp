#include "parser/check/contingent/variables.hpp"

#include <set>
#include <string>
#include <utility>

#include "parser/check/atoms.hpp"
#include "parser/check/contingent/static_condition.hpp"
#include "parser/check/guards.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;

/// Bindings that may be tried for all variables together.
constexpr std::size_t kMaxBindings = 5'000'000;

/// One value of a declaration before it is made ground.
struct LiftedValue {
    std::vector<std::uint32_t> variables;
    Formula condition;
    PredicateId predicate;
    std::vector<Term> terms;
    Location where;
};

class VariableExpander {
  public:
    VariableExpander(Context& context, const syntax::Tree& tree, const std::vector<TupleIndex>& initial_atoms)
        : context_(context), tree_(tree), conditions_(context.task, initial_atoms) {}

    void expand(const syntax::VariableDeclaration& declaration) {
        Scope names;
        values_.clear();
        {
            ScopeBuilder scope(context_, tree_, names);
            scope.bind_parameters(declaration.parameters);
            Guards guards(scope);
            for (const NodeIndex value : declaration.values) collect(scope, guards, value);
            for (std::uint32_t i = declaration.objects.begin; i < declaration.objects.end; ++i) {
                scope.resolve(tree_.names[i]);
            }
        }
        if (values_.empty() || context_.reporter.has_errors()) return;
        std::vector<std::uint32_t> parameters(names.parameter_count);
        for (std::uint32_t i = 0; i < names.parameter_count; ++i) parameters[i] = i;
        std::vector<ObjectId> binding(names.variable_types.size());
        conditions_.for_each_binding(parameters, names, binding,
                                     [&] { return add_variable(declaration, names, binding); });
    }

  private:
    void collect(ScopeBuilder& scope, Guards& guards, NodeIndex index) {
        const Node& node = tree_.nodes[index];
        switch (node.kind) {
            case NodeKind::atom:
                add_value(scope, guards, node);
                break;
            case NodeKind::conjunction:
                tree_.for_each_child(index, [&](NodeIndex child) { collect(scope, guards, child); });
                break;
            case NodeKind::universal:
                guards.universal(index, [&](NodeIndex body) { collect(scope, guards, body); });
                break;
            case NodeKind::when:
                guards.conditional(index, [&](NodeIndex body) { collect(scope, guards, body); });
                break;
            case NodeKind::nested:
                refuse_nested(context_, tree_, node);
                break;
            default:
                context_.reporter.error(tree_.where(node), "the values of a variable are atoms",
                                        "possibly under 'forall' and 'when'");
                break;
        }
    }

    void add_value(ScopeBuilder& scope, Guards& guards, const Node& node) {
        const PredicateId id = resolve_predicate(context_, tree_, node);
        if (!id.valid()) return;
        const Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.derived) {
            context_.reporter.error(tree_.where(node), "the derived predicate " + quote(predicate.name) +
                                                           " cannot be a value of a variable");
        }
        std::optional<std::vector<Term>> terms =
            resolve_arguments(scope, node, "predicate", predicate.parameters);
        if (!terms) return;
        Formula condition = guards.condition(tree_.where(node));
        if (const Formula* changing = StaticConditions::find_changing(condition, context_.task)) {
            context_.reporter.error(changing->where,
                                    "the values of a variable cannot depend on what changes");
        }
        values_.push_back(
            {guards.variables(), std::move(condition), id, std::move(*terms), tree_.where(node)});
    }

    bool add_variable(const syntax::VariableDeclaration& declaration, const Scope& names,
                      std::vector<ObjectId>& binding) {
        MultiValuedVariable variable;
        variable.name = name_of(declaration, names, binding);
        variable.observable = declaration.keyword.symbol == syntax::Word::k_obs_variable;
        variable.where = tree_.where(declaration.name);
        std::set<std::pair<PredicateId, std::vector<ObjectId>>> seen;
        bool small = true;
        for (const LiftedValue& value : values_) {
            small = small && conditions_.for_each_binding(value.variables, names, binding, [&] {
                if (++bindings_ > kMaxBindings) return false;
                if (!conditions_.holds(value.condition, names, binding)) return true;
                GroundLiteral literal{value.predicate, {}, false, value.where};
                for (const Term term : value.terms) {
                    literal.arguments.push_back(StaticConditions::object_of(term, binding));
                }
                if (fits(literal) && seen.emplace(literal.predicate, literal.arguments).second) {
                    variable.values.push_back(std::move(literal));
                }
                return true;
            });
        }
        if (!small) {
            context_.reporter.error(tree_.where(declaration.name), "too many values of this variable");
        } else if (!variable.values.empty()) {
            context_.contingent->variables.push_back(std::move(variable));
        }
        return small;
    }

    /// False for an atom that does not exist since an argument is of another type.
    bool fits(const GroundLiteral& literal) const {
        const std::vector<TypeId>& types = context_.task.predicates[literal.predicate.index()].parameters;
        for (std::size_t i = 0; i < types.size(); ++i) {
            if (!context_.task.types[types[i].index()].contains[literal.arguments[i].index()]) return false;
        }
        return true;
    }

    std::string name_of(const syntax::VariableDeclaration& declaration, const Scope& names,
                        const std::vector<ObjectId>& binding) const {
        std::string arguments;
        for (std::uint32_t i = 0; i < names.parameter_count; ++i) {
            arguments += ' ' + context_.task.objects[binding[i].index()].name;
        }
        for (std::uint32_t i = declaration.objects.begin; i < declaration.objects.end; ++i) {
            arguments += ' ' + context_.text(tree_.names[i].symbol);
        }
        const std::string name = context_.text(declaration.name.symbol);
        return arguments.empty() ? name : name + '(' + arguments.substr(1) + ')';
    }

    Context& context_;
    const syntax::Tree& tree_;
    StaticConditions conditions_;
    std::vector<LiftedValue> values_;
    std::size_t bindings_ = 0;
};

}  // namespace

void check_variables(Context& context, const syntax::Tree& tree,
                     const std::vector<TupleIndex>& initial_atoms) {
    VariableExpander expander(context, tree, initial_atoms);
    for (const syntax::VariableDeclaration& declaration : tree.contingent.variables) {
        expander.expand(declaration);
    }
}

}  // namespace praxis::check
