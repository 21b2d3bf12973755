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
}

std::optional<Fact> AtomNames::fact(const AtomName& atom) const {
    const auto found = literal(atom);
    return found ? fact(*found) : std::nullopt;
}

std::optional<GroundLiteral> AtomNames::literal(const AtomName& atom) const {
    if (atom.words.empty()) return std::nullopt;
    const auto predicate = predicates_.find(atom.words[0]);
    if (predicate == predicates_.end()) return std::nullopt;
    GroundLiteral literal;
    literal.predicate = PredicateId(predicate->second);
    for (std::size_t i = 1; i < atom.words.size(); ++i) {
        const auto object = objects_.find(atom.words[i]);
        if (object == objects_.end()) return std::nullopt;
        literal.arguments.emplace_back(object->second);
    }
    const Predicate& schema = task_->source->task->predicates[literal.predicate.index()];
    if (literal.arguments.size() != schema.parameters.size()) return std::nullopt;
    return literal;
}

std::optional<Fact> AtomNames::fact(const GroundLiteral& literal) const {
    const AtomIndex& atoms = *task_->atoms;
    for (std::uint32_t entry = atoms.find(literal.predicate, literal.arguments); entry != AtomIndex::kAbsent;
         entry = atoms[entry].next) {
        if (atoms[entry].kind != AtomIndex::Entry::Kind::fact) return std::nullopt;
        if (task_->physical->domain_sizes[index(atoms[entry].fact.variable)] == 2 ||
            atoms[entry].next == AtomIndex::kAbsent)
            return atoms[entry].fact;
    }
    return std::nullopt;
}

std::optional<GroundLiteral> AtomNames::literal(Fact fact) const {
    const FiniteDomainTask& physical = *task_->physical;
    const std::uint32_t number = physical.fact_number(fact);
    const auto words = physical.fact_names.names[number];
    if (physical.fact_forms[number] == FiniteDomainTask::FactForm::none_of_those || words.empty())
        return std::nullopt;
    const auto predicate = predicates_.find(physical.fact_names.symbols[words[0]]);
    if (predicate == predicates_.end()) return std::nullopt;
    GroundLiteral literal;
    literal.predicate = PredicateId(predicate->second);
    literal.negated = !physical.is_atom(fact);
    for (std::uint32_t word : words.subspan(1))
        literal.arguments.emplace_back(objects_.at(physical.fact_names.symbols[word]));
    return literal;
}

ActionNames::ActionNames(const FiniteDomainTask& task) {
    for (std::uint32_t a = 0; a < task.operator_count(); ++a)
        actions_.emplace(task.operator_names.words(a), a);
}

std::optional<std::uint32_t> ActionNames::action(const ActionName& name) const {
    const auto found = actions_.find(joined(name.words));
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
