// The elements of a syntax tree: names with their places, ranges of its arrays, nodes.
#pragma once

#include <cstdint>
#include <limits>

#include "parser/syntax/symbols.hpp"

namespace praxis::syntax {

/// A word and its place.
struct Name {
    Symbol symbol{};
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
};

struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool empty() const { return begin == end; }
};

/// `name - type`; several types if written with `either`, none if written without a type.
struct TypedName {
    Name name;
    Range types;  ///< of Tree::names
};

enum class NodeKind : std::uint8_t {
    empty,        ///< ()
    atom,         ///< (p a ?x): a predicate or a function with `arguments`
    nested,       ///< as atom, but with lists among the arguments: the lists are children, the order is lost
    conjunction,  ///< any number of children
    disjunction,
    negation,     ///< one child
    implication,  ///< two children
    existential,  ///< `variables` and one child
    universal,
    when,        ///< two children
    equality,    ///< two operands
    comparison,  ///< < <= > >= (the head), two operands
    arithmetic,  ///< + - * / (the head), operands
    assignment,  ///< increase, ... (the head), two operands
    word,        ///< a name, variable or number where an operand stands
};

struct Node {
    NodeKind kind = NodeKind::empty;
    Name head;
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    std::uint32_t end = 0;  ///< one past the last node of the subtree
    Range arguments;        ///< of Tree::names
    Range variables;        ///< of Tree::typed_names
};

using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = std::numeric_limits<NodeIndex>::max();

}  // namespace praxis::syntax
