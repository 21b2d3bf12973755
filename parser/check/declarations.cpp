#include "parser/check/declarations.hpp"

#include <algorithm>

#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

std::vector<TypeId> parameter_types(Context& context, const syntax::Tree& tree, syntax::Range parameters) {
    std::vector<TypeId> result;
    for (std::uint32_t i = parameters.begin; i < parameters.end; ++i) {
        result.push_back(resolve_type(context, tree, tree.typed_names[i].types));
    }
    return result;
}

bool returns_objects(const syntax::Tree& tree, const syntax::Signature& signature) {
    if (signature.types.empty()) return false;
    return signature.types.end - signature.types.begin > 1 ||
           tree.names[signature.types.begin].symbol != syntax::Word::number;
}

}  // namespace

void declare_predicates(Context& context, const syntax::Tree& domain) {
    for (const syntax::Signature& signature : domain.predicates) {
        const syntax::Symbol symbol = signature.name.symbol;
        const std::string spelled = quote(domain.spelled(signature.name));
        if (symbol == syntax::Word::equal) continue;
        if (syntax::index(symbol) < syntax::index(syntax::symbol_of(syntax::Word::increase))) {
            context.reporter.error(domain.where(signature.name), "a predicate cannot be called " + spelled,
                                   "it is a word of the language");
            continue;
        }
        if (context.predicates[symbol].valid()) {
            context.reporter.error(domain.where(signature.name), "duplicate predicate " + spelled);
            continue;
        }
        context.predicates.set(symbol, PredicateId(context.task.predicates.size()));
        context.task.predicates.push_back({context.text(symbol),
                                           parameter_types(context, domain, signature.parameters), false,
                                           false, domain.where(signature.name)});
    }
}

void declare_functions(Context& context, const syntax::Tree& domain) {
    for (const syntax::Signature& signature : domain.functions) {
        const syntax::Symbol symbol = signature.name.symbol;
        context.use(Feature::action_costs, domain.where(signature.name));
        if (context.functions[symbol].valid() || context.object_functions[syntax::index(symbol)]) {
            context.reporter.error(domain.where(signature.name),
                                   "duplicate function " + quote(domain.spelled(signature.name)));
            continue;
        }
        std::vector<TypeId> parameters = parameter_types(context, domain, signature.parameters);
        if (returns_objects(domain, signature)) {
            resolve_type(context, domain, signature.types);
            context.object_functions[syntax::index(symbol)] = true;
            continue;
        }
        context.functions.set(symbol, FunctionId(context.task.functions.size()));
        context.task.functions.push_back(
            {context.text(symbol), std::move(parameters), domain.where(signature.name)});
    }
}

void declare_total_cost(Context& context, const syntax::Tree& tree) {
    const syntax::Symbol symbol = syntax::symbol_of(syntax::Word::total_cost);
    if (context.functions[symbol].valid() || context.predicates[symbol].valid()) return;
    const auto use = std::find_if(tree.nodes.begin(), tree.nodes.end(),
                                  [&](const syntax::Node& node) { return node.head.symbol == symbol; });
    if (use == tree.nodes.end()) return;
    context.reporter.warning(tree.where(use->head), "function 'total-cost' is used but not declared");
    context.functions.set(symbol, FunctionId(context.task.functions.size()));
    context.task.functions.push_back({"total-cost", {}, tree.where(use->head)});
}

void mark_derived(Context& context, const syntax::Tree& domain) {
    for (const syntax::Derived& derived : domain.axioms) {
        context.use(Feature::derived_predicates, domain.where(derived.head.name));
        const PredicateId id = context.predicates[derived.head.name.symbol];
        if (id.valid()) context.task.predicates[id.index()].derived = true;
    }
}

}  // namespace praxis::check
