// What a file says about partial observability: the part of the syntax tree that classical planning has no
// use for. Node indices and ranges refer to the arrays of the tree that owns it.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/syntax/node.hpp"

namespace praxis::syntax {

/// `:observe LITERAL...` or `:sensing-model EFFECT` in an action.
struct ActionSensing {
    Name keyword;
    std::uint32_t action = 0;      ///< index into Tree::actions
    std::vector<NodeIndex> nodes;  ///< one for a sensing model
};

/// `(:sensor NAME :parameters (...) :condition C :sense LITERAL...)`
struct SensorDeclaration {
    Name name;
    Range parameters;
    NodeIndex condition = kNoNode;
    std::vector<NodeIndex> sensed;
};

/// `(:variable NAME VALUE...)` or `(:variable (NAME PARAMETER...) VALUE...)`, also with `:obs-variable`.
struct VariableDeclaration {
    Name keyword;
    Name name;
    Range parameters;  ///< of typed_names; in a domain
    Range objects;     ///< of names; in a problem
    std::vector<NodeIndex> values;
};

/// Predicates named in `:open-world`, `:observable` or `:sticky`: as words or as nodes.
struct PredicateList {
    Name keyword;
    std::vector<Name> words;
    std::vector<NodeIndex> nodes;
};

/// `(:decay PREDICATE NUMBER)`
struct DecayDeclaration {
    Name predicate;
    Name steps;
};

/// `(:hidden LITERAL...)`
struct HiddenSection {
    Name keyword;
    std::vector<NodeIndex> literals;
};

struct ContingentTree {
    std::vector<ActionSensing> actions;
    std::vector<SensorDeclaration> sensors;
    std::vector<VariableDeclaration> variables;
    std::vector<PredicateList> predicates;
    std::vector<DecayDeclaration> decays;
    std::vector<NodeIndex> default_models;
    std::vector<HiddenSection> hidden;
    std::vector<Range> hidden_objects;  ///< of typed_names
    std::vector<Name> keywords;         ///< every keyword of these constructs, as it was written
};

}  // namespace praxis::syntax
