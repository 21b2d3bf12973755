#include "parser/check/scope.hpp"

#include "parser/check/types.hpp"

namespace praxis::check {

void ScopeBuilder::bind(const syntax::TypedName& variable, TypeId type) {
    bound_.emplace_back(variable.name, context_.variables[variable.name.symbol]);
    context_.variables.set(variable.name.symbol, VariableSlot(scope_.variable_types.size()));
    scope_.variable_types.push_back(type);
    scope_.variable_names.push_back(context_.text(variable.name.symbol));
}

void ScopeBuilder::bind_parameters(syntax::Range variables, const std::vector<TypeId>* fallback) {
    for (std::uint32_t i = variables.begin; i < variables.end; ++i) {
        const syntax::TypedName& variable = tree_.typed_names[i];
        if (context_.variables[variable.name.symbol].valid()) {
            context_.reporter.error(tree_.where(variable.name),
                                    "duplicate variable " + quote(tree_.spelled(variable.name)));
        }
        const std::size_t position = i - variables.begin;
        const bool use_fallback =
            fallback != nullptr && variable.types.empty() && position < fallback->size();
        bind(variable, use_fallback ? (*fallback)[position] : resolve_type(context_, tree_, variable.types));
    }
    scope_.parameter_count = static_cast<std::uint32_t>(scope_.variable_types.size());
}

std::vector<std::uint32_t> ScopeBuilder::bind_quantified(syntax::Range variables) {
    std::vector<std::uint32_t> numbers;
    const std::size_t outer = bound_.size();
    for (std::uint32_t i = variables.begin; i < variables.end; ++i) {
        const syntax::TypedName& variable = tree_.typed_names[i];
        const std::string spelled = quote(tree_.spelled(variable.name));
        const VariableSlot known = context_.variables[variable.name.symbol];
        bool same_list = false;
        for (std::size_t j = outer; j < bound_.size(); ++j) {
            same_list = same_list || bound_[j].first.symbol == variable.name.symbol;
        }
        if (same_list) {
            context_.reporter.error(tree_.where(variable.name), "duplicate variable " + spelled);
        } else if (known.valid()) {
            context_.reporter.warning(tree_.where(variable.name),
                                      "variable " + spelled + " hides another one");
        }
        numbers.push_back(static_cast<std::uint32_t>(scope_.variable_types.size()));
        bind(variable, resolve_type(context_, tree_, variable.types));
    }
    return numbers;
}

void ScopeBuilder::unbind(std::size_t visible) {
    for (; bound_.size() > visible; bound_.pop_back()) {
        context_.variables.set(bound_.back().first.symbol, bound_.back().second);
    }
}

std::optional<Term> ScopeBuilder::resolve(const syntax::Name& word) {
    if (tree_.text[word.offset] == '?') {
        const VariableSlot slot = context_.variables[word.symbol];
        if (slot.valid()) return Term::variable(slot.index());
        report_unbound(word);
        return std::nullopt;
    }
    const ObjectId object = context_.objects[word.symbol];
    if (object.valid()) return Term::object(object);
    report_unknown_object(word);
    return std::nullopt;
}

void ScopeBuilder::report_unbound(const syntax::Name& word) {
    Suggestion suggestion(context_.symbols.text(word.symbol));
    for (const auto& [name, before] : bound_) suggestion.consider(context_.symbols.text(name.symbol));
    context_.reporter.error(tree_.where(word), "unbound variable " + quote(tree_.spelled(word)),
                            suggestion.hint());
}

void ScopeBuilder::report_unknown_object(const syntax::Name& word) {
    const std::string question = '?' + context_.text(word.symbol);
    for (const auto& [name, before] : bound_) {
        if (context_.symbols.text(name.symbol) != question) continue;
        context_.reporter.error(tree_.where(word), "unknown object " + quote(tree_.spelled(word)),
                                "did you mean " + quote(question) + '?');
        return;
    }
    context_.report_unknown("object", tree_, word, context_.task.objects);
}

}  // namespace praxis::check
