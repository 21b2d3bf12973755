// The public header of praxis: load a task, ground it once, plan as often as needed.
//
//     praxis::Task task = praxis::load("domain.pddl", "problem.pddl");
//     praxis::Session session(task);
//     praxis::Result result = session.plan(praxis::alias("agile"));
//     if (result.plan) std::cout << praxis::to_string(*result.plan, *task);
//
// Sessions are independent of each other and may run on different threads; one session belongs to one thread
// at a time. The same task, configuration and seed give the same plan, if the clock ends no part of the
// search. Input errors are praxis::InputError (from `load`); wrong use is std::invalid_argument; a search
// that fails is a status.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parser/parser.hpp"
#include "search/budget.hpp"
#include "search/engines/search.hpp"
#include "search/ground/ground.hpp"
#include "search/plan.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct Result {
    Status status = Status::failed;
    std::optional<Plan> plan;  ///< the best plan found, whatever ended the search
    SearchStatistics statistics;
    bool optimal = false;  ///< the search proved that no plan is cheaper
    /// The task was too large to ground, and a lifted search answered in place of the configuration's.
    bool lifted = false;
};

/// What a caller may watch. Never called twice at once; where several threads search, on any of them.
struct Callbacks {
    std::function<void(const Plan&)> on_plan;                  ///< each better plan, as found
    std::function<void(const SearchStatistics&)> on_progress;  ///< a few times a second
};

/// A ground atom for `set_initial_state` and `set_goal`.
struct Atom {
    PredicateId predicate;
    std::vector<ObjectId> arguments;
    friend bool operator==(const Atom&, const Atom&) = default;
};

/// A goal condition: the atom holds, or (negated) does not.
struct GoalLiteral {
    Atom atom;
    bool negated = false;
};

struct SessionOptions {
    GroundOptions ground;
    /// The initial state and the goal will change: ground without pruning by the goal.
    bool replanning = true;
    /// Where grounding would take more than two fifths of the time or half of the memory that the budget
    /// leaves, plan without grounding (see `search/lifted`).
    bool lifted_fallback = true;
};

class Session {
  public:
    /// Grounds the task. If the budget runs out, `ground_task` is null and the next `plan` tries again with
    /// its own; if only grounding's share of it does, `plan` searches without.
    explicit Session(Task task, const SessionOptions& options = {}, const Budget& budget = {});
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// Plans from the current initial state to the current goal. Throws std::invalid_argument for a
    /// configuration that is wrong.
    Result plan(const Configuration& configuration, const Budget& budget = {},
                const Callbacks& callbacks = {});

    /// The atoms that hold (complete; closed world; static atoms may be left out and then keep their value).
    /// The next `plan` grounds again only if the ground task cannot express the state. Throws
    /// std::invalid_argument for unknown ids, wrong arity or types, and derived predicates, and then changes
    /// nothing.
    void set_initial_state(const std::vector<Atom>& atoms);
    /// A conjunction of literals. The next `plan` grounds again only if the ground task cannot express it.
    void set_goal(const std::vector<GoalLiteral>& goal);

    /// The task with the present initial state and goal; valid until they change.
    const LiftedTask& task() const;
    /// The ground task now in use; null if grounding ran out of its budget.
    std::shared_ptr<const FiniteDomainTask> ground_task() const;
    /// The task was too large to ground; `plan` searches without.
    bool lifted() const;
    const std::vector<PhaseStatistics>& phases() const;
    /// How often the session has grounded (1 unless a changed state or goal needed new facts).
    int groundings() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace praxis
