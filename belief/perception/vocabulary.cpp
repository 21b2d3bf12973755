#include "belief/perception/vocabulary.hpp"

namespace praxis::belief {
namespace {

/// "(either a b)": written where it is used, never declared.
bool is_anonymous(const Type& type) {
    return type.name.starts_with('(');
}

}  // namespace

Vocabulary vocabulary_of(const LiftedTask& task) {
    Vocabulary vocabulary;
    for (std::size_t i = 1; i < task.types.size(); ++i) {
        if (is_anonymous(task.types[i])) continue;
        VocabularyType& type = vocabulary.types.emplace_back(VocabularyType{task.types[i].name, {}});
        for (const TypeId parent : task.types[i].parents) {
            const Type& above = task.types[parent.index()];
            if (parent.index() != 0 && !is_anonymous(above)) type.parents.push_back(above.name);
        }
    }
    for (const Predicate& predicate : task.predicates) {
        if (predicate.name == "=") continue;
        VocabularyPredicate& known =
            vocabulary.predicates.emplace_back(VocabularyPredicate{predicate.name, {}});
        for (const TypeId type : predicate.parameters) {
            known.parameters.push_back(task.types[type.index()].name);
        }
    }
    for (const Object& object : task.objects) {
        vocabulary.objects.push_back({object.name, task.types[object.type.index()].name});
    }
    return vocabulary;
}

std::string vocabulary_domain(const Vocabulary& vocabulary) {
    std::string text = "(define (domain goals)\n(:requirements :adl :typing)\n";
    if (!vocabulary.types.empty()) {
        text += "(:types";
        for (const VocabularyType& type : vocabulary.types) {
            if (type.parents.empty()) text += "\n" + type.name + " - object";
            for (const std::string& parent : type.parents) text += "\n" + type.name + " - " + parent;
        }
        text += ")\n";
    }
    text += "(:predicates";
    for (const VocabularyPredicate& predicate : vocabulary.predicates) {
        text += "\n(" + predicate.name;
        for (std::size_t i = 0; i < predicate.parameters.size(); ++i) {
            text += " ?x" + std::to_string(i + 1) + " - " + predicate.parameters[i];
        }
        text += ')';
    }
    return text + "))\n";
}

std::string vocabulary_problem(const Vocabulary& vocabulary, const std::string& goal) {
    std::string text = "(define (problem goal) (:domain goals)\n(:objects";
    for (const VocabularyObject& object : vocabulary.objects)
        text += "\n" + object.name + " - " + object.type;
    return text + ")\n(:init)\n(:goal\n" + goal + "\n))\n";
}

}  // namespace praxis::belief
