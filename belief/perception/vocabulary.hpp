// The names that goals and questions may use: types, predicates and objects, without actions.
#pragma once

#include <string>
#include <vector>

#include "parser/task.hpp"

namespace praxis::belief {

struct VocabularyType {
    std::string name;
    std::vector<std::string> parents;  ///< direct supertypes; empty: `object`
};

struct VocabularyPredicate {
    std::string name;
    std::vector<std::string> parameters;  ///< type names, also "(either a b)"
};

struct VocabularyObject {
    std::string name;
    std::string type;
};

struct Vocabulary {
    std::vector<VocabularyType> types;  ///< without `object`
    std::vector<VocabularyPredicate> predicates;
    std::vector<VocabularyObject> objects;
};

/// What a task knows; objects found later can be added.
Vocabulary vocabulary_of(const LiftedTask& task);

/// A domain without actions, for checking goals.
std::string vocabulary_domain(const Vocabulary& vocabulary);

/// A problem with the objects and a goal, which stands on lines of its own.
std::string vocabulary_problem(const Vocabulary& vocabulary, const std::string& goal);

}  // namespace praxis::belief
