#include "search/validate/executor.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

#include "search/validate/describe.hpp"

namespace praxis::validation {

namespace {

constexpr std::size_t kReported = 8;

std::vector<FactTable> tables_of(const LiftedTask& task) {
    std::vector<FactTable> tables;
    tables.reserve(task.predicates.size());
    for (const Predicate& predicate : task.predicates) {
        tables.emplace_back(static_cast<std::uint32_t>(predicate.parameters.size()));
    }
    return tables;
}

void fill(FactTable& table, const Relation& relation) {
    std::vector<std::uint32_t> tuple(relation.arity + std::size_t{1});
    for (std::size_t i = 0; i < relation.count; ++i) {
        const auto arguments = relation.tuple(i);
        std::transform(arguments.begin(), arguments.end(), tuple.begin(),
                       [](ObjectId o) { return o.index(); });
        table.insert(tuple.data());
    }
}

/// A function without a value for these arguments.
struct Undefined {
    std::string term;
};

}  // namespace

Executor::Executor(const LiftedTask& task)
    : task_(task),
      tables_(tables_of(task)),
      evaluator_(task, tables_),
      derived_(task, tables_, evaluator_),
      schemas_(task.schemas.size()) {
    for (std::size_t p = 0; p < tables_.size() && p < task.initial_atoms.size(); ++p) {
        if (!task.predicates[p].derived) fill(tables_[p], task.initial_atoms[p]);
    }
    for (std::size_t f = 0; f < task.functions.size(); ++f) {
        functions_.emplace_back(static_cast<std::uint32_t>(task.functions[f].parameters.size()));
        if (f < task.initial_values.size()) fill(functions_[f], task.initial_values[f].tuples);
    }
}

void Executor::split(const Formula& formula, std::vector<Conjunct>& out) const {
    if (formula.kind == Connective::conjunction) {
        for (const Formula& child : formula.children) split(child, out);
    } else if (formula.kind != Connective::truth) {
        out.push_back({&formula, compile(formula)});
    }
}

const Executor::CompiledSchema& Executor::compiled(SchemaId id) {
    std::unique_ptr<CompiledSchema>& slot = schemas_[id.index()];
    if (slot) return *slot;
    slot = std::make_unique<CompiledSchema>();
    const Schema& schema = task_.schemas[id.index()];
    std::set<std::uint32_t> components;
    const auto use = [&](const Condition& condition) {
        const std::vector<std::uint32_t> used = derived_.components_for(condition);
        components.insert(used.begin(), used.end());
    };
    split(schema.precondition, slot->precondition);
    for (const Conjunct& conjunct : slot->precondition) use(conjunct.condition);
    for (const Effect& effect : schema.effects) {
        CompiledEffect& target = slot->effects.emplace_back();
        target.effect = &effect;
        target.condition = compile(effect.condition);
        use(target.condition);
        for (const std::uint32_t variable : effect.variables) {
            if (std::find(effect.terms.begin(), effect.terms.end(), Term::variable(variable)) !=
                effect.terms.end()) {
                target.wanted.push_back(variable);
            }
        }
    }
    slot->components.assign(components.begin(), components.end());
    return *slot;
}

std::optional<std::string> Executor::misfit(const PlanStep& step) const {
    if (step.schema.index() >= task_.schemas.size()) return "there is no such action";
    const Schema& schema = task_.schemas[step.schema.index()];
    if (step.arguments.size() != schema.scope.parameter_count) {
        return "the action takes " + std::to_string(schema.scope.parameter_count) + " arguments, not " +
               std::to_string(step.arguments.size());
    }
    for (std::size_t i = 0; i < step.arguments.size(); ++i) {
        const std::uint32_t object = step.arguments[i].index();
        if (object >= task_.objects.size()) return "argument " + std::to_string(i + 1) + " is not an object";
        const Type& type = task_.types[schema.scope.variable_types[i].index()];
        if (!type.contains[object]) {
            return "'" + task_.objects[object].name + "' is not of type '" + type.name + "' as parameter " +
                   schema.scope.variable_names[i] + " wants";
        }
    }
    return std::nullopt;
}

std::optional<std::string> Executor::execute(const PlanStep& step) {
    if (auto reason = misfit(step)) return reason;
    const Schema& schema = task_.schemas[step.schema.index()];
    const CompiledSchema& compiled_schema = compiled(step.schema);
    derived_.update(compiled_schema.components);
    evaluator_.enter(schema.scope);
    for (std::uint32_t i = 0; i < step.arguments.size(); ++i) evaluator_.bind(i, step.arguments[i].index());

    const bool applicable =
        std::all_of(compiled_schema.precondition.begin(), compiled_schema.precondition.end(),
                    [this](const Conjunct& conjunct) { return evaluator_.holds(conjunct.condition); });
    if (!applicable) return "precondition " + failures(compiled_schema.precondition, schema.scope);
    try {
        const Rational increase = schema.cost ? evaluate(*schema.cost) : Rational();
        cost_ = cost_ + (task_.minimize_cost ? increase : Rational(1));
    } catch (const Undefined& undefined) {
        return "its cost needs " + undefined.term + ", which has no value" +
               describe(schema.cost->where, task_);
    } catch (const std::overflow_error&) {
        return "its cost does not fit into a fraction of 64-bit integers";
    } catch (const std::domain_error&) {
        return "its cost divides by zero" + describe(schema.cost->where, task_);
    }
    for (const CompiledEffect& effect : compiled_schema.effects) collect(effect);
    apply();
    return std::nullopt;
}

void Executor::collect(const CompiledEffect& compiled_effect) {
    const Effect& effect = *compiled_effect.effect;
    std::vector<std::uint32_t>& changes = changes_[effect.add ? 1 : 0];
    const auto note = [&] {
        changes.push_back(effect.predicate.index());
        for (const Term term : effect.terms) changes.push_back(evaluator_.value(term));
        return false;
    };
    if (effect.variables.empty()) {
        if (evaluator_.holds(compiled_effect.condition)) note();
        return;
    }
    if (!evaluator_.inhabited(effect.variables)) return;
    const Condition* condition = &compiled_effect.condition;
    evaluator_.enumerate({&condition, 1}, compiled_effect.wanted, note);
}

void Executor::apply() {
    for (std::size_t add = 0; add < 2; ++add) {
        const std::vector<std::uint32_t>& changes = changes_[add];
        for (std::size_t i = 0; i < changes.size();) {
            FactTable& table = tables_[changes[i]];
            if (add == 1) {
                table.insert(changes.data() + i + 1);
            } else {
                table.erase(changes.data() + i + 1);
                table.compact();
            }
            i += std::size_t{1} + table.arity();
        }
        changes_[add].clear();
    }
}

Rational Executor::evaluate(const Expression& expression) const {
    using Operator = Expression::Kind;
    const auto child = [&](std::size_t i) { return evaluate(expression.children.at(i)); };
    const auto fold = [&](auto combine) {
        Rational result = child(0);
        for (std::size_t i = 1; i < expression.children.size(); ++i) result = combine(result, child(i));
        return result;
    };
    switch (expression.kind) {
        case Operator::constant:
            return expression.value;
        case Operator::add:
            return fold([](Rational a, Rational b) { return a + b; });
        case Operator::subtract:
            return fold([](Rational a, Rational b) { return a - b; });
        case Operator::multiply:
            return fold([](Rational a, Rational b) { return a * b; });
        case Operator::divide:
            return fold([](Rational a, Rational b) { return a / b; });
        case Operator::negate:
            return -child(0);
        case Operator::function:
            break;
    }
    std::vector<std::uint32_t> tuple(expression.terms.size() + 1);
    std::transform(expression.terms.begin(), expression.terms.end(), tuple.begin(),
                   [this](Term term) { return evaluator_.value(term); });
    const std::uint32_t row = functions_[expression.function.index()].find(tuple.data());
    if (row != FactTable::kNone) return task_.initial_values[expression.function.index()].values[row];
    std::vector<ObjectId> arguments(tuple.begin(), tuple.end() - 1);
    throw Undefined{describe(task_.functions[expression.function.index()].name, arguments, task_)};
}

std::optional<std::string> Executor::goal_failure() {
    std::vector<Conjunct> goal;
    split(task_.goal, goal);
    for (const Conjunct& conjunct : goal) derived_.update(derived_.components_for(conjunct.condition));
    evaluator_.enter(task_.goal_scope);
    const std::string reason = failures(goal, task_.goal_scope);
    if (reason.empty()) return std::nullopt;
    return reason;
}

std::string Executor::failures(const std::vector<Conjunct>& conjuncts, const Scope& scope) {
    const Binding binding = [this](std::uint32_t variable) {
        const std::uint32_t object = evaluator_.value(variable);
        return object == Evaluator::kUnbound ? ObjectId() : ObjectId(object);
    };
    std::string text;
    std::size_t failed = 0;
    for (const Conjunct& conjunct : conjuncts) {
        if (evaluator_.holds(conjunct.condition) || ++failed > kReported) continue;
        text += failed == 1 ? "" : "; nor does ";
        text += describe(*conjunct.formula, scope, task_, binding) + (failed == 1 ? " does not hold" : "");
        text += counterexample(conjunct, scope) + describe(conjunct.formula->where, task_);
    }
    if (failed > kReported) text += "; and " + std::to_string(failed - kReported) + " more";
    return text;
}

std::string Executor::counterexample(const Conjunct& conjunct, const Scope& scope) {
    if (conjunct.condition.kind != Condition::Kind::none) return "";
    std::string text;
    const Condition* body = &conjunct.condition.children.front();
    evaluator_.enumerate({&body, 1}, conjunct.condition.variables, [&] {
        for (const std::uint32_t variable : conjunct.condition.variables) {
            text += (text.empty() ? ": consider " : ", ") + scope.variable_names[variable] + " = " +
                    task_.objects[evaluator_.value(variable)].name;
        }
        return true;
    });
    return text;
}

}  // namespace praxis::validation
