// What a plan must not do, learned after grounding: a ground task that forbids it, with the same operators.
//
// An *event* is the application of an operator in a state where some facts hold, or the end of the plan in
// such a state. A *nogood* is a set of events that must not all happen in one plan. So a nogood of one event
// says: never this operator where all these facts hold; and with no facts: never this operator.
//
// Encoding. A fact that must not hold is the other value of a binary variable, or a new binary variable, its
// complement, that the operators keep up to date. "Not all of these facts" is a derived variable with an
// axiom for each of them. (Axioms for all other values of a fact's variable, which need no complements, make
// searches several times slower where variables have many values.) Events of nogoods that have several leave
// a mark, a variable that the operator's effect sets. An operator that is never to be applied needs a fact
// that nothing makes true, so that operators keep their numbers.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct Event {
    OperatorId op;            ///< invalid: the end of the plan
    std::vector<Fact> facts;  ///< at most one a variable
    friend bool operator==(const Event&, const Event&) = default;
};

struct Nogood {
    std::vector<Event> events;
    friend bool operator==(const Nogood&, const Nogood&) = default;
};

/// The task under these nogoods. Operators and the first variables keep their numbers; variables are added
/// behind. Throws std::invalid_argument for operators or facts that the task does not have, nogoods without
/// events, and events with two values of one variable.
std::shared_ptr<const FiniteDomainTask> restrict(const FiniteDomainTask& task,
                                                 std::span<const Nogood> nogoods);

}  // namespace praxis
