// The typed syntax tree of one file: what was written and where, before anything is known about what names
// mean.
//
// The tree is a few flat arrays. Conditions, effects, expressions and initial facts are all *nodes* of one
// array in preorder: the children of node i are i + 1, nodes[i + 1].end, ... up to nodes[i].end. Names are
// symbols of the table that all files of a task share. A Range is a half-open range of one of the arrays.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "parser/source.hpp"
#include "parser/syntax/contingent_tree.hpp"
#include "parser/syntax/node.hpp"
#include "parser/syntax/stream_tree.hpp"

namespace praxis::syntax {

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
    std::vector<Name> refused;    ///< sections that are understood but not supported
    std::vector<Name> misplaced;  ///< `:objects` in a domain, `:constants` in a problem
    ContingentTree contingent;
    StreamTree streams;
    bool broken = false;  ///< some section had a syntax error and is missing

    Location where(const Name& word) const { return {file, word.offset, word.length}; }
    Location where(const Node& node) const { return {file, node.offset, node.length}; }
    std::string_view spelled(const Name& word) const { return text.substr(word.offset, word.length); }

    /// The words among the arguments of a node of kind `nested`, without those inside of its lists.
    std::vector<Name> own_words(NodeIndex parent) const {
        std::vector<Name> words;
        NodeIndex child = parent + 1;
        for (std::uint32_t i = nodes[parent].arguments.begin; i < nodes[parent].arguments.end; ++i) {
            const auto past = [&] { return nodes[child].offset + nodes[child].length <= names[i].offset; };
            while (child < nodes[parent].end && past()) child = nodes[child].end;
            if (child >= nodes[parent].end || names[i].offset < nodes[child].offset)
                words.push_back(names[i]);
        }
        return words;
    }

    /// Calls visit(NodeIndex) for every child of a node.
    template <class Visit>
    void for_each_child(NodeIndex parent, Visit visit) const {
        for (NodeIndex child = parent + 1; child < nodes[parent].end; child = nodes[child].end) visit(child);
    }
};

}  // namespace praxis::syntax
