// What every estimate of a state looks like to a search.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "search/state/ids.hpp"
#include "search/task/ids.hpp"

namespace praxis {

/// All variables' values, derived ones included, one after the other.
using StateView = std::span<const std::int32_t>;

/// An estimate of the cost or distance to the goal, or kDeadEnd.
using Estimate = std::int32_t;
inline constexpr Estimate kDeadEnd = std::numeric_limits<Estimate>::max();

/// How a component counts operator costs: as they are, as one each, or as cost plus one (unless all costs are
/// one).
enum class CostType : std::uint8_t { normal, one, plus_one };

/// Estimates states of one task; owns scratch memory and so belongs to one thread. A heuristic is an
/// evaluator whose estimates are goal distances.
class Evaluator {
  public:
    virtual ~Evaluator() = default;
    Evaluator() = default;
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    /// `state` is complete. Costs at least the work of one virtual call: never call it more than once a
    /// state.
    virtual Estimate evaluate(StateView state) = 0;

    /// A path-dependent evaluator keeps something for each state about the ways to it. The search then says
    /// where it starts and which transitions it makes, also those to states it knows already, and before it
    /// evaluates a state that it is about to. Parents were children before, or the start.
    virtual bool path_dependent() const { return false; }
    virtual void start(StateId /*initial*/, StateView /*state*/) {}
    /// `op` leads from `parent` to `child`, whose complete values are `state`.
    virtual void follow(StateId /*parent*/, OperatorId /*op*/, StateId /*child*/, StateView /*state*/) {}
    /// The next call of `evaluate` is about this state.
    virtual void at(StateId /*state*/) {}

    /// What the search's other evaluators say of the state that is evaluated next, for evaluators that build
    /// on others.
    virtual void given(std::span<const std::int64_t> /*values*/) {}

    /// Preferred operators of the state last evaluated, in no particular order, without repetition; valid
    /// until the next call. Computed only after `request_preferred()`.
    virtual std::span<const OperatorId> preferred() const { return {}; }
    virtual void request_preferred() {}

    /// About how many nanoseconds the last evaluation took, by counting its steps: where searches take turns,
    /// this is what they count, so that runs can be repeated.
    virtual std::uint64_t effort() const { return 100; }

    /// kDeadEnd is a proof that no plan starts in the state.
    virtual bool safe() const = 0;
    virtual bool admissible() const = 0;
    virtual bool consistent() const = 0;
};

}  // namespace praxis
