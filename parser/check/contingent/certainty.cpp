#include "parser/check/contingent/certainty.hpp"

namespace praxis::check {

Certainty::Atoms::Atoms(const LiftedTask& task) : relations_(task.predicates.size()) {
    indices_.reserve(relations_.size());
    for (std::size_t i = 0; i < relations_.size(); ++i) {
        relations_[i].arity = static_cast<std::uint32_t>(task.predicates[i].parameters.size());
        indices_.emplace_back(relations_[i]);
    }
}

void Certainty::Atoms::insert(const GroundLiteral& literal) {
    indices_[literal.predicate.index()].insert(literal.arguments);
}

bool Certainty::Atoms::contains(const GroundLiteral& literal) const {
    return indices_[literal.predicate.index()].find(literal.arguments) != TupleIndex::kNone;
}

Certainty::Certainty(Context& context, const std::vector<TupleIndex>& initial_atoms)
    : context_(context),
      initial_atoms_(initial_atoms),
      uncertain_(context.task),
      false_(context.task),
      warned_(context.task.predicates.size(), false) {
    const ContingentTask& task = *context.contingent;
    for (const GroundLiteral& literal : task.known_false) false_.insert(literal);
    for (const GroundLiteral& literal : task.unknown) uncertain_.insert(literal);
    for (const Clause& clause : task.clauses) {
        for (const GroundLiteral& literal : clause.literals) uncertain_.insert(literal);
    }
    for (const MultiValuedVariable& variable : task.variables) {
        for (const GroundLiteral& literal : variable.values) uncertain_.insert(literal);
    }
}

void Certainty::check(const GroundLiteral& literal) {
    const std::size_t predicate = literal.predicate.index();
    const bool stated_true = initial_atoms_[predicate].find(literal.arguments) != TupleIndex::kNone;
    const bool stated_false = false_.contains(literal);
    if (literal.negated ? stated_true : stated_false) {
        context_.reporter.warning(literal.where, "the initial state says the opposite",
                                  "this world is not what is believed of it");
        return;
    }
    if (literal.negated || stated_true || uncertain_.contains(literal)) return;
    if (context_.contingent->open_world[predicate] || warned_[predicate]) return;
    warned_[predicate] = true;
    context_.reporter.warning(literal.where, "nothing in ':init' says that this may be true",
                              "what ':init' does not mention is false; 'unknown' makes it uncertain");
}

}  // namespace praxis::check
