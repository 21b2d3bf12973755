// The rules of the grammar: typed lists, and the nested lists that conditions, effects, expressions and facts
// are made of. Their actions grow the tree. For grammar.cpp, which has the sections.
#pragma once

#include "parser/syntax/tokens.hpp"

namespace praxis::syntax {
namespace {

// Actions.

const auto open = [](auto& context) { builder(context).open(x3::_attr(context)); };
const auto close = [](auto& context) { builder(context).close(x3::_attr(context)); };
const auto enter = [](auto& context) { builder(context).enter(x3::_attr(context)); };
const auto leave = [](auto& context) { builder(context).leave(); };
const auto add_argument = [](auto& context) { builder(context).add_argument(x3::_attr(context)); };
const auto mark_nested = [](auto& context) { builder(context).mark_nested(); };
const auto add_word = [](auto& context) { builder(context).add_word(x3::_attr(context)); };
const auto bind = [](auto& context) { builder(context).bind(builder(context).list()); };
const auto begin_list = [](auto& context) { builder(context).begin_list(); };
const auto add_item = [](auto& context) { builder(context).add_item(x3::_attr(context)); };
const auto begin_types = [](auto& context) { builder(context).begin_types(); };
const auto add_type = [](auto& context) { builder(context).add_type(x3::_attr(context)); };
const auto apply_types = [](auto& context) { builder(context).apply_types(); };

template <NodeKind kind>
const auto head = [](auto& context) { builder(context).set_head(kind, x3::_attr(context)); };

// Typed lists.

const x3::rule<struct TypeClass> type("a type");
const auto either = (opening >> word(Word::either)) > *name[add_type] > closing("a type or ')'");
const auto type_def = x3::eps[begin_types] >> (name[add_type] | either);

template <class Item>
auto typed_list(const Item& item) {
    return x3::eps[begin_list] >> *((+item[add_item]) >> (-(word(Word::minus) > type)[apply_types]));
}

const x3::rule<struct NamesClass> typed_names("names");
const x3::rule<struct VariablesClass> typed_variables("variables");
const auto typed_names_def = typed_list(name);
const auto typed_variables_def = typed_list(variable);

// Conditions, effects, expressions, facts.

const x3::rule<struct ListClass> list("'('");
const x3::rule<struct BodyClass> body("a predicate or a word such as 'and', 'not', 'forall'");
const x3::rule<struct OperandClass> operand("a name, a variable, a number or '('");

const auto argument = term[add_argument] | list[mark_nested];
const auto operand_def = operand_word[add_word] | list;
const auto close_atom = closing("an argument or ')'")[close];
const auto close_lists = closing("'(' or ')'")[close];
const auto close_operands = closing("an operand or ')'")[close];
const auto close_list = closing()[close];

template <NodeKind kind, class... Words>
auto one_of(Words... words) {
    return (word(words)[head<kind>] | ...);
}

const auto comparison =
    one_of<NodeKind::comparison>(Word::less, Word::less_equal, Word::greater, Word::greater_equal);
const auto arithmetic = one_of<NodeKind::arithmetic>(Word::plus, Word::minus, Word::times, Word::divide);
const auto assignment = one_of<NodeKind::assignment>(Word::increase, Word::decrease, Word::assign,
                                                     Word::scale_up, Word::scale_down);

// An assignment's first operand is a list; otherwise its word is a predicate like any other.
const auto body_def = (free_name[head<NodeKind::atom>] > *argument > close_atom) |
                      (word(Word::conjunction)[head<NodeKind::conjunction>] > *list > close_lists) |
                      (word(Word::negation)[head<NodeKind::negation>] > list > close_list) |
                      (word(Word::equal)[head<NodeKind::equality>] > operand > operand > close_list) |
                      (word(Word::disjunction)[head<NodeKind::disjunction>] > *list > close_lists) |
                      (word(Word::implication)[head<NodeKind::implication>] > list > list > close_list) |
                      (word(Word::when)[head<NodeKind::when>] > list > list > close_list) |
                      ((word(Word::universal)[head<NodeKind::universal>] |
                        word(Word::existential)[head<NodeKind::existential>]) > opening > typed_variables >
                       closing("a variable or ')'")[bind] > list > close_list) |
                      (comparison > operand > operand > close_list) |
                      (arithmetic > *operand > close_operands) |
                      ((assignment >> &opening) > operand > operand > close_list) |
                      (name[head<NodeKind::atom>] > *argument > close_atom) | close_list;

const auto list_def = opening[open] > body;

// Sections that are skipped.
const x3::rule<struct SkippedClass> skipped("'('");
const auto skipped_def = opening[enter] > *(any_word | skipped) > closing("a word, '(' or ')'")[leave];

BOOST_SPIRIT_DEFINE(type, typed_names, typed_variables, list, body, operand, skipped)

}  // namespace
}  // namespace praxis::syntax
