// Conditions made ready for grounding, and their evaluation under a binding: what is decided by what never
// changes (or is never reached) goes away, what is left is a disjunction of conjunctions of literals.
//
// Quantifiers do not enumerate all objects: the positive atoms under `exists`, and the negated ones under
// `forall`, are joined, and only their matches looked at. A product of disjunctions is multiplied out while
// it stays small; otherwise auxiliary derived atoms stand for the factors.
#pragma once

#include <map>
#include <vector>

#include "search/ground/condition.hpp"
#include "search/ground/join.hpp"
#include "search/ground/proposition_task.hpp"

namespace praxis::grounding {

/// A condition with its join plans.
struct GroundableCondition {
    Condition::Kind kind = Condition::Kind::truth;
    bool negated = false;
    RelationId relation = 0;
    std::vector<std::int32_t> terms;  ///< a variable, or ~object
    JoinPlan plan;                    ///< quantifiers: extends the binding by what has to be looked at
    std::vector<GroundableCondition> children;
};

class ConditionGrounder {
  public:
    ConditionGrounder(Relations& relations, const std::vector<bool>& exact, PropositionTask& task)
        : relations_(relations), exact_(exact), task_(task) {}

    /// `bound`: by variable, what has a value when the condition is grounded.
    GroundableCondition prepare(const Condition& condition, const std::vector<TypeId>& variable_types,
                                std::vector<bool> bound) const;
    /// A plan over the generators of a conjunction that gives values to `variables`.
    JoinPlan generator_plan(std::span<const Condition> conjuncts, bool negate,
                            const std::vector<BodyAtom>& more, const std::vector<std::uint32_t>& variables,
                            const std::vector<TypeId>& variable_types, const std::vector<bool>& bound) const;

    /// The disjunction that the condition comes to; empty: it is false; an empty conjunction in it: it is
    /// true. At most `most` conjunctions.
    void ground(const GroundableCondition& condition, Object* binding, std::size_t most, Disjunction& result);

    /// A derived atom that holds if the disjunction does; the same for the same disjunction.
    AtomId auxiliary(Disjunction disjunction);

    /// The atom of a tuple: a number, or what is known about it.
    enum class Known : std::uint8_t { no, yes, open };
    Known look_up(RelationId relation, const Object* tuple, AtomId& atom) const;

    /// The budget ran out in the middle of a join: results are incomplete.
    bool stopped() const { return stopped_; }

  private:
    using Factors = std::vector<Disjunction>;

    bool add(const GroundableCondition& condition, Object* binding, Conjunction& literals, Factors& factors);
    bool add_disjunction(const GroundableCondition& condition, Object* binding, Conjunction& literals,
                         Factors& factors);
    bool add_alternative(const GroundableCondition& condition, Object* binding, Disjunction& alternatives);
    void multiply_out(Conjunction literals, Factors factors, std::size_t most, Disjunction& result);
    Known evaluate(const GroundableCondition& literal, const Object* binding, AtomId& atom);

    Relations& relations_;
    const std::vector<bool>& exact_;
    PropositionTask& task_;
    std::map<Disjunction, AtomId> auxiliaries_;
    std::vector<Object> tuple_;
    bool stopped_ = false;
};

/// Sorts, removes repetitions; false if the conjunction contradicts itself.
bool tidy(Conjunction& conjunction);
/// Sorts, removes repetitions and conjunctions that others imply.
void tidy(Disjunction& disjunction);

}  // namespace praxis::grounding
