#include "search/lifted/actions.hpp"

#include <algorithm>

#include "search/ground/condition.hpp"
#include "search/lifted/query_compiler.hpp"

namespace praxis::lifted {

namespace {

bool has_functions(const Expression& expression) {
    return expression.kind == Expression::Kind::function ||
           std::ranges::any_of(expression.children, has_functions);
}

std::vector<TermCode> codes(const std::vector<Term>& terms) {
    std::vector<TermCode> result;
    for (const Term term : terms)
        result.push_back(term.is_variable() ? static_cast<TermCode>(term.variable_index())
                                            : ~static_cast<TermCode>(term.object_id().index()));
    return result;
}

}  // namespace

Actions::Actions(Database& database, QuerySolver& solver) : database_(database), solver_(solver) {
    const LiftedTask& task = database.task();
    std::size_t most_arguments = 0;
    for (const Predicate& predicate : task.predicates)
        most_arguments = std::max(most_arguments, predicate.parameters.size());
    tuple_.resize(most_arguments);
    for (const Schema& schema : task.schemas) {
        Compiled compiled{grounding::CostEvaluator(task, schema), false, {}, {}, {}};
        compiled.cost_varies = schema.cost && has_functions(*schema.cost);
        compiled.binding.assign(schema.scope.variable_types.size(), QuerySolver::kUnbound);
        std::vector<std::uint32_t> parameters(schema.scope.parameter_count);
        for (std::uint32_t i = 0; i < parameters.size(); ++i) parameters[i] = i;
        QueryCompiler compiler(database, schema.scope.variable_types);
        const grounding::Condition precondition = grounding::normalise(schema.precondition);
        compiled.preconditions = compiler.compile(precondition, parameters, parameters);
        for (const Effect& effect : schema.effects) {
            Outcome outcome{effect.add, {effect.predicate.index(), codes(effect.terms)}, {}, false, {}};
            const grounding::Condition condition = grounding::normalise(effect.condition);
            outcome.always = effect.variables.empty() && condition.kind == grounding::Condition::Kind::truth;
            if (!outcome.always)
                outcome.conditions = compiler.compile(condition, effect.variables, effect.variables);
            add_support(precondition, outcome.support);
            add_support(condition, outcome.support);
            if (outcome.always || !outcome.conditions.empty())
                compiled.outcomes.push_back(std::move(outcome));
        }
        // Adds first: of an atom that is added and deleted, the add wins.
        std::stable_partition(compiled.outcomes.begin(), compiled.outcomes.end(),
                              [](const Outcome& outcome) { return outcome.add; });
        schemas_.push_back(std::move(compiled));
    }
}

void Actions::add_support(const grounding::Condition& condition, std::vector<Head>& support) const {
    for (const grounding::Condition& part : grounding::conjuncts(condition)) {
        if (part.kind != grounding::Condition::Kind::literal || part.negated) continue;
        if (!database_.task().predicates[part.predicate.index()].fluent) continue;
        support.push_back({part.predicate.index(), codes(part.terms)});
    }
}

void Actions::collect(const Outcome& outcome, const ObjectNumber* binding) {
    const ObjectNumber* tuple = arguments(outcome.head, binding);
    if (!outcome.add) {
        const AtomNumber atom = database_.atoms().find(outcome.head.predicate, tuple);
        if (atom == kNoAtom || !database_.holds(atom)) return;
        if (atom < added_stamp_.size() && added_stamp_[atom] == stamp_) return;
        change_.deleted.push_back(atom);
        return;
    }
    const AtomNumber atom = database_.intern(outcome.head.predicate, tuple);
    if (atom >= added_stamp_.size()) added_stamp_.resize(std::size_t{atom} * 2 + 64, 0);
    if (added_stamp_[atom] == stamp_) return;
    added_stamp_[atom] = stamp_;
    if (!database_.holds(atom)) change_.added.push_back(atom);
}

const Change& Actions::change(std::uint32_t schema) {
    Compiled& compiled = schemas_[schema];
    change_.added.clear();
    change_.deleted.clear();
    ++stamp_;
    for (Outcome& outcome : compiled.outcomes) {
        if (outcome.always) {
            collect(outcome, compiled.binding.data());
            continue;
        }
        for (Query& condition : outcome.conditions)
            solver_.solve(condition, compiled.binding.data(),
                          [&] { collect(outcome, compiled.binding.data()); });
    }
    std::ranges::sort(change_.added);
    std::ranges::sort(change_.deleted);
    change_.deleted.erase(std::unique(change_.deleted.begin(), change_.deleted.end()), change_.deleted.end());
    return change_;
}

Rational Actions::cost(std::uint32_t schema) {
    Compiled& compiled = schemas_[schema];
    if (!database_.task().minimize_cost) return Rational(1);
    compiled.cost.evaluate(compiled.binding.data());
    return compiled.cost.value();
}

}  // namespace praxis::lifted
