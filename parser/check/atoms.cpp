#include "parser/check/atoms.hpp"

#include "parser/check/contingent/refuse.hpp"
#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

using syntax::Word;

std::string quoted(const syntax::Tree& tree, const syntax::Name& name) {
    return quote(tree.spelled(name));
}

bool is_constraint(syntax::Symbol symbol) {
    const auto first = syntax::symbol_of(Word::always);
    return symbol >= first && symbol <= syntax::symbol_of(Word::hold_after);
}

bool is_time_point(syntax::Symbol symbol) {
    return symbol == Word::start || symbol == Word::end || symbol == Word::all;
}

/// A warning where the types allow the argument for some objects, an error where for none.
void check_type(ScopeBuilder& scope, const syntax::Name& word, Term term, TypeId wanted) {
    Context& context = scope.context();
    const TypeId given = scope.type_of(term);
    const bool object_fits =
        !term.is_variable() && context.task.types[wanted.index()].contains[term.object_id().index()];
    if (object_fits || is_subtype(context, given, wanted)) return;
    if (context.types_missing && given == TypeId(0)) return;
    const std::string message = quoted(scope.tree(), word) + " is of type " +
                                quote(context.task.types[given.index()].name) + "; " +
                                quote(context.task.types[wanted.index()].name) + " is wanted here";
    const bool possible =
        term.is_variable() && (is_subtype(context, wanted, given) || overlap(context, given, wanted));
    if (possible) {
        context.reporter.warning(scope.tree().where(word), message);
    } else {
        context.reporter.error(scope.tree().where(word), message);
    }
}

}  // namespace

PredicateId resolve_predicate(Context& context, const syntax::Tree& tree, const syntax::Node& node) {
    const PredicateId id = context.predicates[node.head.symbol];
    if (id.valid()) return id;
    if (context.functions[node.head.symbol].valid()) {
        context.reporter.error(tree.where(node.head),
                               quoted(tree, node.head) + " is a function, not a predicate");
    } else {
        context.report_unknown("predicate", tree, node.head, context.task.predicates);
    }
    return id;
}

FunctionId resolve_function(Context& context, const syntax::Tree& tree, const syntax::Node& node) {
    const FunctionId id = context.functions[node.head.symbol];
    if (id.valid()) return id;
    if (context.object_functions[syntax::index(node.head.symbol)]) {
        context.reporter.unsupported(tree.where(node.head), "object fluents");
    } else {
        context.report_unknown("function", tree, node.head, context.task.functions);
    }
    return id;
}

void report_arity(Context& context, const syntax::Tree& tree, const syntax::Node& node, std::string_view kind,
                  const std::vector<TypeId>& parameters) {
    const std::size_t given = node.arguments.end - node.arguments.begin;
    std::string types;
    for (const TypeId type : parameters) types += ' ' + context.task.types[type.index()].name;
    std::string message = std::string(kind) + ' ' + quoted(tree, node.head) + " takes ";
    message += parameters.empty()       ? "no arguments"
               : parameters.size() == 1 ? "1 argument"
                                        : std::to_string(parameters.size()) + " arguments";
    context.reporter.error(tree.where(node), message + ", not " + std::to_string(given),
                           parameters.empty() ? "" : "of types" + types);
}

std::optional<std::vector<Term>> resolve_arguments(ScopeBuilder& scope, const syntax::Node& node,
                                                   std::string_view kind,
                                                   const std::vector<TypeId>& parameters) {
    const syntax::Tree& tree = scope.tree();
    const std::size_t given = node.arguments.end - node.arguments.begin;
    std::vector<Term> terms;
    terms.reserve(given);
    for (std::uint32_t i = node.arguments.begin; i < node.arguments.end; ++i) {
        const std::optional<Term> term = scope.resolve(tree.names[i]);
        if (!term) continue;
        if (given == parameters.size())
            check_type(scope, tree.names[i], *term, parameters[i - node.arguments.begin]);
        terms.push_back(*term);
    }
    if (given != parameters.size()) report_arity(scope.context(), tree, node, kind, parameters);
    if (terms.size() != parameters.size()) return std::nullopt;
    return terms;
}

void refuse_nested(Context& context, const syntax::Tree& tree, const syntax::Node& node) {
    const syntax::Symbol head = node.head.symbol;
    const Location where = tree.where(node.head);
    const syntax::Name* const first = node.arguments.empty() ? nullptr : &tree.names[node.arguments.begin];
    const bool known = context.predicates[head].valid() || context.functions[head].valid() ||
                       context.object_functions[syntax::index(head)];
    if (head == Word::preference) {
        context.reporter.unsupported(where, "preferences");
    } else if (is_constraint(head) && !known) {
        context.reporter.unsupported(where, "trajectory constraints");
    } else if ((head == Word::at || head == Word::over) && first && Rational::parse(tree.spelled(*first))) {
        context.reporter.unsupported(where, "timed initial literals");
    } else if ((head == Word::at || head == Word::over) && first && is_time_point(first->symbol)) {
        context.reporter.unsupported(where, "durative conditions and effects");
    } else if (head == Word::oneof && !known) {
        context.reporter.unsupported(where, "nondeterministic effects");
    } else if (head == Word::unknown && !known) {
        context.reporter.unsupported(where, "conditions and effects on knowledge",
                                     context.contingent == nullptr ? std::string(kBeliefHint) : "");
    } else if (known) {
        context.reporter.unsupported(where, "object fluents (lists as arguments)");
    } else {
        Suggestion suggestion(context.symbols.text(head));
        for (auto word = Word::conjunction; word != Word::equal;
             word = static_cast<Word>(static_cast<std::uint32_t>(word) + 1)) {
            suggestion.consider(syntax::spelling(word));
        }
        for (const Predicate& predicate : context.task.predicates) suggestion.consider(predicate.name);
        context.reporter.error(where, "unknown predicate " + quoted(tree, node.head), suggestion.hint());
    }
}

}  // namespace praxis::check
