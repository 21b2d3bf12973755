#include "parser/write/scope_text.hpp"

#include <algorithm>

namespace praxis::write {

ScopeText::ScopeText(const LiftedTask& task, const Scope& scope, std::string& out)
    : task_(task), scope_(scope), out_(out), names_(scope.variable_types.size()) {
    for (std::uint32_t i = 0; i < scope.parameter_count; ++i) bind(i);
}

void ScopeText::parameters(const char* before) {
    for (std::uint32_t i = 0; i < scope_.parameter_count; ++i) {
        out_ += i == 0 ? before : " ";
        out_ += names_[i] + " - " + task_.types[scope_.variable_types[i].index()].name;
    }
}

void ScopeText::formula(const Formula& formula_node) {
    const std::size_t outer = visible_.size();
    switch (formula_node.kind) {
        case Connective::truth:
            out_ += "(and)";
            break;
        case Connective::falsity:
            out_ += "(or)";
            break;
        case Connective::atom:
            atom(formula_node.predicate, formula_node.terms);
            break;
        case Connective::equality:
            out_ += "(=";
            for (const Term operand : formula_node.terms) term(operand);
            out_ += ')';
            break;
        case Connective::negation:
            joined("(not", formula_node.children);
            break;
        case Connective::conjunction:
            joined("(and", formula_node.children);
            break;
        case Connective::disjunction:
            joined("(or", formula_node.children);
            break;
        case Connective::implication:
            joined("(imply", formula_node.children);
            break;
        case Connective::existential:
        case Connective::universal:
            quantifier(formula_node.kind == Connective::universal ? "(forall " : "(exists ",
                       formula_node.variables);
            formula(formula_node.children.front());
            out_ += ')';
            break;
    }
    visible_.resize(outer);
}

void ScopeText::expression(const Expression& expression_node) {
    const auto operation = [&](const char* head) {
        out_ += head;
        for (const Expression& child : expression_node.children) {
            out_ += ' ';
            expression(child);
        }
        out_ += ')';
    };
    switch (expression_node.kind) {
        case Expression::Kind::constant: {
            const std::string number = expression_node.value.to_string();
            const std::size_t bar = number.find('/');
            out_ += bar == std::string::npos
                        ? number
                        : "(/ " + number.substr(0, bar) + ' ' + number.substr(bar + 1) + ')';
            break;
        }
        case Expression::Kind::function:
            out_ += '(' + task_.functions[expression_node.function.index()].name;
            for (const Term argument : expression_node.terms) term(argument);
            out_ += ')';
            break;
        case Expression::Kind::add:
            operation("(+");
            break;
        case Expression::Kind::multiply:
            operation("(*");
            break;
        case Expression::Kind::divide:
            operation("(/");
            break;
        case Expression::Kind::subtract:
        case Expression::Kind::negate:
            operation("(-");
            break;
    }
}

void ScopeText::atom(PredicateId predicate, const std::vector<Term>& terms) {
    out_ += '(' + task_.predicates[predicate.index()].name;
    for (const Term argument : terms) term(argument);
    out_ += ')';
}

void ScopeText::quantifier(const char* head, const std::vector<std::uint32_t>& variables) {
    out_ += head;
    char separator = '(';
    for (const std::uint32_t variable : variables) {
        bind(variable);
        out_ +=
            separator + names_[variable] + " - " + task_.types[scope_.variable_types[variable].index()].name;
        separator = ' ';
    }
    out_ += variables.empty() ? "() " : ") ";
}

void ScopeText::joined(const char* head, const std::vector<Formula>& children) {
    out_ += head;
    for (const Formula& child : children) {
        out_ += ' ';
        formula(child);
    }
    out_ += ')';
}

void ScopeText::term(Term term_value) {
    out_ += ' ';
    out_ += term_value.is_variable() ? names_[term_value.variable_index()]
                                     : task_.objects[term_value.object_id().index()].name;
}

void ScopeText::bind(std::uint32_t variable) {
    std::string name = variable < scope_.variable_names.size() ? scope_.variable_names[variable] : "";
    if (name.size() < 2 || name.front() != '?') name = "?v" + std::to_string(variable);
    const std::string stem = name;
    for (std::size_t i = 2; is_visible(name); ++i) name = stem + '_' + std::to_string(i);
    names_[variable] = std::move(name);
    visible_.push_back(variable);
}

bool ScopeText::is_visible(const std::string& name) const {
    return std::any_of(visible_.begin(), visible_.end(),
                       [&](std::uint32_t variable) { return names_[variable] == name; });
}

}  // namespace praxis::write
