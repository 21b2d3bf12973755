#include "parser/check/schemas.hpp"

#include "parser/check/atoms.hpp"
#include "parser/check/conditions.hpp"
#include "parser/check/contingent/sensing.hpp"
#include "parser/check/effects.hpp"
#include "parser/check/types.hpp"

namespace praxis::check {
namespace {

void check_axiom(Context& context, const syntax::Tree& domain, const syntax::Derived& derived) {
    const PredicateId predicate = context.predicates[derived.head.name.symbol];
    const std::vector<TypeId>* parameters = nullptr;
    const std::size_t given = derived.head.parameters.end - derived.head.parameters.begin;
    if (predicate.valid()) {
        parameters = &context.task.predicates[predicate.index()].parameters;
        if (parameters->size() != given) {
            context.reporter.error(domain.where(derived.head.name),
                                   "predicate " + quote(domain.spelled(derived.head.name)) + " has " +
                                       std::to_string(parameters->size()) + " parameters, its axiom " +
                                       std::to_string(given));
        }
    } else {
        context.report_unknown("predicate", domain, derived.head.name, context.task.predicates);
    }
    Axiom axiom;
    axiom.predicate = predicate;
    axiom.where = domain.where(derived.head.name);
    ScopeBuilder scope(context, domain, axiom.scope);
    scope.bind_parameters(derived.head.parameters, parameters);
    axiom.body = check_condition(scope, derived.body);
    context.task.axioms.push_back(std::move(axiom));
}

}  // namespace

void check_schemas(Context& context, const syntax::Tree& domain) {
    context.task.schemas.reserve(domain.actions.size());
    std::size_t sensing = 0;
    for (const syntax::Action& action : domain.actions) {
        if (context.schemas[action.name.symbol].valid()) {
            context.reporter.error(domain.where(action.name),
                                   "duplicate action " + quote(domain.spelled(action.name)));
        }
        context.schemas.set(action.name.symbol, SchemaId(context.task.schemas.size()));
        Schema& schema = context.task.schemas.emplace_back();
        schema.name = context.text(action.name.symbol);
        schema.where = domain.where(action.name);
        ScopeBuilder scope(context, domain, schema.scope);
        scope.bind_parameters(action.parameters);
        schema.precondition = check_condition(scope, action.precondition);
        if (context.contingent != nullptr) context.contingent->sensing.emplace_back();
        check_effects(scope, action.effect, schema);
        if (context.contingent != nullptr) sensing = check_action_sensing(scope, sensing);
    }
}

void check_axioms(Context& context, const syntax::Tree& domain) {
    for (const syntax::Derived& derived : domain.axioms) check_axiom(context, domain, derived);
}

}  // namespace praxis::check
