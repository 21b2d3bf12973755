// What a stream file says: the part of the syntax tree that only task and motion planning has a use for. Node
// indices and ranges refer to the arrays of the tree that owns it.
#pragma once

#include <vector>

#include "parser/syntax/node.hpp"

namespace praxis::syntax {

/// `(:stream NAME :inputs (...) :domain C :outputs (...) :certified C :fluents (...))`, or
/// `(:function (NAME PARAMETER...) C)`, also with `:predicate`: then the parameters are the inputs.
struct StreamDeclaration {
    Name keyword;
    Name name;
    Range inputs;   ///< of Tree::typed_names
    Range outputs;  ///< of Tree::typed_names
    std::vector<NodeIndex> domain;
    std::vector<NodeIndex> certified;
    std::vector<Name> fluents;
};

struct StreamTree {
    std::vector<StreamDeclaration> streams;
    std::vector<StreamDeclaration> functions;
    std::vector<StreamDeclaration> predicates;
};

}  // namespace praxis::syntax
