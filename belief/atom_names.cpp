#include "belief/atom_names.hpp"

namespace praxis::belief {
namespace {

std::vector<std::string> words_of(const NameTable& names, std::size_t i) {
    std::vector<std::string> words;
    for (std::uint32_t word : names.names[i]) words.push_back(names.symbols[word]);
    return words;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

}  // namespace

AtomNames::AtomNames(const BeliefTask& task) : task_(&task) {
    const LiftedTask& lifted = *task.source->task;
    for (std::size_t p = 0; p < lifted.predicates.size(); ++p)
        predicates_.emplace(lifted.predicates[p].name, p);
    for (std::size_t o = 0; o < lifted.objects.size(); ++o) objects_.emplace(lifted.objects[o].name, o);
    for (std::uint32_t a = 0; a < task.operator_count(); ++a)
        actions_.emplace(task.physical->operator_names.words(a), a);
}

std::optional<Fact> AtomNames::fact(const AtomName& atom) const {
    if (atom.words.empty()) return std::nullopt;
    const auto predicate = predicates_.find(atom.words[0]);
    if (predicate == predicates_.end()) return std::nullopt;
    std::vector<ObjectId> arguments;
    for (std::size_t i = 1; i < atom.words.size(); ++i) {
        const auto object = objects_.find(atom.words[i]);
        if (object == objects_.end()) return std::nullopt;
        arguments.emplace_back(object->second);
    }
    const PredicateId id(predicate->second);
    if (arguments.size() != task_->source->task->predicates[id.index()].parameters.size())
        return std::nullopt;
    const AtomIndex& atoms = *task_->atoms;
    for (std::uint32_t entry = atoms.find(id, arguments); entry != AtomIndex::kAbsent;
         entry = atoms[entry].next) {
        if (atoms[entry].kind != AtomIndex::Entry::Kind::fact) return std::nullopt;
        if (task_->physical->domain_sizes[static_cast<std::size_t>(atoms[entry].fact.variable)] == 2 ||
            atoms[entry].next == AtomIndex::kAbsent)
            return atoms[entry].fact;
    }
    return std::nullopt;
}

std::optional<std::uint32_t> AtomNames::action(const ActionName& action) const {
    const auto found = actions_.find(joined(action.words));
    if (found == actions_.end()) return std::nullopt;
    return found->second;
}

AtomName AtomNames::name(const FiniteDomainTask& task, Fact fact) {
    return {words_of(task.fact_names, task.fact_number(fact))};
}

ActionName AtomNames::name(const FiniteDomainTask& task, std::uint32_t action) {
    return {words_of(task.operator_names, action)};
}

}  // namespace praxis::belief
