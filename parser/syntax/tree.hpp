// The typed syntax tree of one file: what was written and where, before anything is known about what names
// mean.
//
// The tree is a few flat arrays. Conditions, effects, expressions and initial facts are all *nodes* of one
// array in preorder: the children of node i are i + 1, nodes[i + 1].end, ... up to nodes[i].end. Names are
// symbols of the table that all files of a task share. A Range is a half-open range of one of the arrays.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "parser/source.hpp"
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

/// A predicate, a function or the head of an axiom.
struct Signature {
    Name name;
    Range parameters;  ///< of Tree::typed_names
    Range types;       ///< functions: of Tree::names
};

struct Action {
    Name name;
    Range parameters;
    NodeIndex precondition = kNoNode;
    NodeIndex effect = kNoNode;
};

struct Derived {
    Signature head;
    NodeIndex body = kNoNode;
};

struct Metric {
    Name direction;
    NodeIndex expression = kNoNode;
};

struct Tree {
    std::uint32_t file = 0;
    std::string_view text;

    std::vector<Node> nodes;
    std::vector<Name> names;
    std::vector<TypedName> typed_names;

    std::optional<Name> name;             ///< of the domain or problem
    std::optional<Name> domain;           ///< what a problem says its domain is
    std::optional<Name> requirements_at;  ///< the first :requirements
    std::vector<Name> requirements;
    std::vector<Range> types;    ///< of typed_names, one a section
    std::vector<Range> objects;  ///< of typed_names; the constants of a domain
    std::vector<Signature> predicates;
    std::vector<Signature> functions;
    std::vector<Action> actions;
    std::vector<Derived> axioms;
    std::vector<NodeIndex> init;
    std::vector<Name> init_sections;
    std::vector<NodeIndex> goals;
    std::vector<Metric> metrics;
    std::vector<Name> refused;  ///< sections that are understood but not supported
    bool broken = false;        ///< some section had a syntax error and is missing

    Location where(const Name& word) const { return {file, word.offset, word.length}; }
    Location where(const Node& node) const { return {file, node.offset, node.length}; }
    std::string_view spelled(const Name& word) const { return text.substr(word.offset, word.length); }

    /// Calls visit(NodeIndex) for every child of a node.
    template <class Visit>
    void for_each_child(NodeIndex parent, Visit visit) const {
        for (NodeIndex child = parent + 1; child < nodes[parent].end; child = nodes[child].end) visit(child);
    }
};

}  // namespace praxis::syntax
