#include "parser/check/streams/streams.hpp"

#include <algorithm>
#include <utility>

#include "parser/check/atoms.hpp"
#include "parser/check/scope.hpp"
#include "parser/check/streams/monotone.hpp"
#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeIndex;
using syntax::NodeKind;
using syntax::StreamDeclaration;

class StreamChecker {
  public:
    StreamChecker(Context& context, const syntax::Tree& tree, StreamTask& result)
        : context_(context), tree_(tree), result_(result) {}

    void run() {
        result_.certified.assign(context_.task.predicates.size(), false);
        for (const StreamDeclaration& declaration : tree_.streams.streams) check_stream(declaration);
        for (const StreamDeclaration& declaration : tree_.streams.predicates) check_predicate(declaration);
        for (const StreamDeclaration& declaration : tree_.streams.functions) check_function(declaration);
        check_monotone(context_, result_.certified);
    }

  private:
    std::string spelled(const syntax::Name& name) const { return quote(tree_.spelled(name)); }

    void check_name(const StreamDeclaration& declaration) {
        const auto same = [&](const auto& other) {
            return other.name == context_.symbols.text(declaration.name.symbol);
        };
        if (std::ranges::any_of(result_.streams, same))
            context_.reporter.error(tree_.where(declaration.name),
                                    "duplicate stream " + spelled(declaration.name));
    }

    void check_stream(const StreamDeclaration& declaration) {
        check_name(declaration);
        StreamSchema stream;
        stream.name = context_.text(declaration.name.symbol);
        stream.where = tree_.where(declaration.name);
        ScopeBuilder scope(context_, tree_, stream.scope);
        scope.bind_parameters(declaration.inputs);
        for (const NodeIndex node : declaration.domain) collect_domain(scope, node, stream.domain);
        check_outputs(declaration);
        scope.bind_quantified(declaration.outputs);
        for (const NodeIndex node : declaration.certified) collect(scope, node, stream.certified);
        for (const LiftedAtom& atom : stream.certified)
            certify(atom.predicate, tree_.where(declaration.name));
        if (stream.certified.empty())
            context_.reporter.error(stream.where,
                                    "stream " + spelled(declaration.name) + " certifies nothing",
                                    "say with ':certified' what its samples are good for");
        check_use(declaration, stream);
        add_output_types(stream);
        for (const syntax::Name& name : declaration.fluents) add_fluent(name, stream);
        result_.streams.push_back(std::move(stream));
    }

    void check_outputs(const StreamDeclaration& declaration) {
        for (std::uint32_t i = declaration.outputs.begin; i < declaration.outputs.end; ++i) {
            const syntax::Name& output = tree_.typed_names[i].name;
            for (std::uint32_t j = declaration.inputs.begin; j < declaration.inputs.end; ++j)
                if (tree_.typed_names[j].name.symbol == output.symbol)
                    context_.reporter.error(tree_.where(output), spelled(output) + " is an input already");
        }
    }

    void check_use(const StreamDeclaration& declaration, const StreamSchema& stream) {
        const auto inputs = static_cast<std::uint32_t>(stream.input_count());
        const auto used = [](const std::vector<LiftedAtom>& atoms, std::uint32_t variable) {
            return std::ranges::any_of(atoms, [&](const LiftedAtom& atom) {
                return std::ranges::find(atom.terms, Term::variable(variable)) != atom.terms.end();
            });
        };
        for (std::uint32_t i = 0; i < stream.output_count(); ++i)
            if (!used(stream.certified, inputs + i))
                context_.reporter.warning(tree_.where(tree_.typed_names[declaration.outputs.begin + i].name),
                                          "nothing is certified of this output");
        for (std::uint32_t i = 0; i < inputs; ++i)
            if (stream.scope.variable_types[i] == TypeId(0) && !used(stream.domain, i))
                context_.reporter.warning(tree_.where(tree_.typed_names[declaration.inputs.begin + i].name),
                                          "any object can be this input", "say in ':domain' which");
    }

    void add_output_types(StreamSchema& stream) {
        for (std::size_t i = stream.input_count(); i < stream.scope.variable_types.size(); ++i) {
            std::vector<TypeId>& types = stream.output_types.emplace_back();
            for (std::size_t type = 0; type < context_.task.types.size(); ++type)
                if (is_subtype(context_, stream.scope.variable_types[i], TypeId(type)))
                    types.emplace_back(type);
        }
    }

    void check_predicate(const StreamDeclaration& declaration) {
        const PredicateId predicate = context_.predicates[declaration.name.symbol];
        if (!predicate.valid())
            return context_.report_unknown("predicate", tree_, declaration.name, context_.task.predicates);
        check_name(declaration);
        StreamSchema stream;
        stream.name = context_.text(declaration.name.symbol);
        stream.where = tree_.where(declaration.name);
        const std::vector<TypeId>& types = context_.task.predicates[predicate.index()].parameters;
        if (!check_parameters(declaration, "predicate", types)) return;
        ScopeBuilder scope(context_, tree_, stream.scope);
        scope.bind_parameters(declaration.inputs, &types);
        for (const NodeIndex node : declaration.domain) collect_domain(scope, node, stream.domain);
        LiftedAtom& atom = stream.certified.emplace_back();
        atom.predicate = predicate;
        for (std::size_t i = 0; i < types.size(); ++i) atom.terms.push_back(Term::variable(i));
        certify(predicate, stream.where);
        result_.streams.push_back(std::move(stream));
    }

    void check_function(const StreamDeclaration& declaration) {
        FunctionSchema function;
        function.function = context_.functions[declaration.name.symbol];
        function.where = tree_.where(declaration.name);
        if (!function.function.valid())
            return context_.report_unknown("function", tree_, declaration.name, context_.task.functions);
        for (const FunctionSchema& other : result_.functions)
            if (other.function == function.function)
                context_.reporter.error(function.where, "duplicate function " + spelled(declaration.name));
        const std::vector<TypeId>& types = context_.task.functions[function.function.index()].parameters;
        if (!check_parameters(declaration, "function", types)) return;
        ScopeBuilder scope(context_, tree_, function.scope);
        scope.bind_parameters(declaration.inputs, &types);
        for (const NodeIndex node : declaration.domain) collect_domain(scope, node, function.domain);
        result_.functions.push_back(std::move(function));
    }

    bool check_parameters(const StreamDeclaration& declaration, std::string_view kind,
                          const std::vector<TypeId>& types) {
        const std::size_t given = declaration.inputs.end - declaration.inputs.begin;
        if (given == types.size()) return true;
        context_.reporter.error(tree_.where(declaration.name),
                                std::string(kind) + ' ' + spelled(declaration.name) + " takes " +
                                    std::to_string(types.size()) + " arguments, not " +
                                    std::to_string(given));
        return false;
    }

    /// The atoms of a conjunction.
    void collect(ScopeBuilder& scope, NodeIndex index, std::vector<LiftedAtom>& atoms) {
        const Node& node = tree_.nodes[index];
        if (node.kind == NodeKind::empty) return;
        if (node.kind == NodeKind::conjunction)
            return tree_.for_each_child(index, [&](NodeIndex child) { collect(scope, child, atoms); });
        if (node.kind == NodeKind::nested) return refuse_nested(context_, tree_, node);
        if (node.kind != NodeKind::atom)
            return context_.reporter.error(tree_.where(node), "expected atoms, joined with 'and'");
        const PredicateId predicate = resolve_predicate(context_, tree_, node);
        if (!predicate.valid()) return;
        std::optional<std::vector<Term>> terms = resolve_arguments(
            scope, node, "predicate", context_.task.predicates[predicate.index()].parameters);
        if (terms) atoms.push_back({predicate, std::move(*terms)});
    }

    void collect_domain(ScopeBuilder& scope, NodeIndex index, std::vector<LiftedAtom>& atoms) {
        const std::size_t before = atoms.size();
        collect(scope, index, atoms);
        for (std::size_t i = before; i < atoms.size(); ++i) {
            const Predicate& predicate = context_.task.predicates[atoms[i].predicate.index()];
            if (!predicate.fluent && !predicate.derived) continue;
            context_.reporter.error(tree_.where(tree_.nodes[index]),
                                    "a domain cannot have " + quote(predicate.name) + ", which " +
                                        (predicate.fluent ? "actions change" : "is derived"),
                                    predicate.fluent ? "list it under ':fluents'" : "");
        }
    }

    void certify(PredicateId id, Location where) {
        const Predicate& predicate = context_.task.predicates[id.index()];
        if (predicate.fluent || predicate.derived)
            context_.reporter.error(where, "a stream cannot certify " + quote(predicate.name) + ", which " +
                                               (predicate.fluent ? "actions change" : "is derived"));
        result_.certified[id.index()] = true;
    }

    void add_fluent(const syntax::Name& name, StreamSchema& stream) {
        const PredicateId predicate = context_.predicates[name.symbol];
        if (!predicate.valid())
            return context_.report_unknown("predicate", tree_, name, context_.task.predicates);
        if (context_.task.predicates[predicate.index()].derived)
            return context_.reporter.error(tree_.where(name),
                                           "the derived predicate " + spelled(name) + " cannot be a fluent",
                                           "list what it is derived from");
        stream.fluents.push_back(predicate);
    }

    Context& context_;
    const syntax::Tree& tree_;
    StreamTask& result_;
};

}  // namespace

void check_streams(Context& context, const syntax::Tree& tree, StreamTask& result) {
    StreamChecker(context, tree, result).run();
}

}  // namespace praxis::check
