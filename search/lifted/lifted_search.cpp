#include "search/lifted/lifted_search.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>
#include <vector>

#include "search/engines/bucket_queue.hpp"
#include "search/engines/search_monitor.hpp"
#include "search/lifted/actions.hpp"
#include "search/lifted/axioms.hpp"
#include "search/lifted/goal.hpp"
#include "search/lifted/novelty_table.hpp"
#include "search/lifted/state_store.hpp"

namespace praxis {

namespace lifted {
namespace {

using Atoms = std::vector<AtomNumber>;

/// Two queues over the same states, asked in turn.
class OpenList {
  public:
    void push(StateNumber state, std::uint32_t missing, std::size_t goals, int novelty) {
        const auto push_to = [&](Fifo<StateNumber>& bucket) { bucket.push(pool_, state); };
        novel_.fill(static_cast<std::int64_t>(static_cast<std::size_t>(novelty) * (goals + 1) + missing), push_to);
        greedy_.fill(missing, push_to);
    }
    bool empty() const { return novel_.empty() && greedy_.empty(); }
    StateNumber pop() {
        const auto take = [&](Fifo<StateNumber>& bucket) { return bucket.pop(pool_); };
        greedy_turn_ = !greedy_turn_;
        const bool greedy = novel_.empty() || (greedy_turn_ && !greedy_.empty());
        return greedy ? greedy_.take(take) : novel_.take(take);
    }

  private:
    ChunkPool<StateNumber> pool_;
    KeyedBuckets<Fifo<StateNumber>> novel_, greedy_;
    bool greedy_turn_ = false;
};

class Search {
  public:
    Search(const LiftedTask& task, const Budget& budget, const LiftedOptions& options,
           const std::function<void(const SearchStatistics&)>& on_progress)
        : task_(task),
          budget_(budget),
          on_progress_(on_progress),
          database_(task),
          solver_(database_, budget),
          axioms_(database_, solver_),
          actions_(database_, solver_),
          goal_(database_, solver_),
          novelty_(options.pair_bits) {}

    LiftedOutcome run();

  private:
    static constexpr std::uint32_t kExpanded = 1;

    StateNumber start();
    /// Expands a state; returns a goal state if it is one or leads to one.
    StateNumber expand(StateNumber state);
    void load(const Atoms& atoms) {
        database_.load(atoms);
        axioms_.derive();
    }
    void apply(const Change& change);
    void extract_plan(StateNumber goal, LiftedOutcome& outcome);
    void add_step(const Atoms& before, const Atoms& after, Plan& plan);
    /// Now and then: reports, and asks whether to go on.
    bool look();
    void fill_statistics();

    const LiftedTask& task_;
    Budget budget_;
    const std::function<void(const SearchStatistics&)>& on_progress_;
    Database database_;
    QuerySolver solver_;
    Axioms axioms_;
    Actions actions_;
    Goal goal_;
    NoveltyTable novelty_;
    StateStore states_;
    OpenList open_;
    SearchStatistics statistics_;
    Budget::Clock::time_point start_ = Budget::Clock::now();
    Budget::Clock::time_point next_report_ = start_;
    Atoms atoms_, child_;
};

StateNumber Search::start() {
    Atoms initial;
    std::vector<ObjectNumber> arguments;
    for (PredicateNumber p = 0; p < task_.predicates.size(); ++p) {
        if (!task_.predicates[p].fluent) continue;
        const Relation& relation = task_.initial_atoms[p];
        for (std::size_t i = 0; i < relation.count; ++i) {
            arguments.clear();
            for (const ObjectId object : relation.tuple(i)) arguments.push_back(object.index());
            initial.push_back(database_.intern(p, arguments.data()));
        }
    }
    database_.finish();
    axioms_.finish();
    goal_.finish();
    std::ranges::sort(initial);
    const StateNumber state = states_.insert(initial, kNoState).first;
    novelty_.measure(goal_.literals_missing(initial), initial, initial, true);
    return state;
}

void Search::apply(const Change& change) {
    child_.clear();
    auto added = change.added.begin();
    auto deleted = change.deleted.begin();
    for (const AtomNumber atom : atoms_) {
        for (; added != change.added.end() && *added < atom; ++added) child_.push_back(*added);
        if (deleted != change.deleted.end() && *deleted == atom)
            ++deleted;
        else
            child_.push_back(atom);
    }
    child_.insert(child_.end(), added, change.added.end());
}

StateNumber Search::expand(StateNumber state) {
    states_.read(state, atoms_);
    load(atoms_);
    const std::uint32_t literals = goal_.literals_missing(atoms_);
    const std::uint32_t conditions = goal_.conditions_missing();
    if (literals + conditions == 0 && !solver_.stopped()) return state;
    ++statistics_.expanded;
    StateNumber found = kNoState;
    actions_.for_each_applicable([&](std::uint32_t schema, const ObjectNumber*) {
        if (found != kNoState) return;
        ++statistics_.generated;
        const Change& change = actions_.change(schema);
        if ((change.added.empty() && change.deleted.empty()) || solver_.stopped()) return;
        apply(change);
        const auto [child, fresh] = states_.insert(child_, state);
        if (!fresh) return;
        ++statistics_.evaluated;
        const std::uint32_t missing = goal_.literals_missing(literals, change);
        if (missing == 0 && goal_.simple()) found = child;
        const auto estimate = static_cast<std::int32_t>(missing + conditions);
        if (!statistics_.best_estimate || estimate < *statistics_.best_estimate) statistics_.best_estimate = estimate;
        const int novelty = novelty_.measure(missing + conditions, child_, change.added, missing != literals);
        open_.push(child, missing + conditions, goal_.size(), novelty);
    });
    return found;
}

bool Search::look() {
    const auto now = Budget::Clock::now();
    if (on_progress_ && now >= next_report_) {
        next_report_ = now + std::chrono::milliseconds(250);
        fill_statistics();
        on_progress_(statistics_);
    }
    return budget_.exhausted() == Stop::none;
}

void Search::fill_statistics() {
    statistics_.seconds = std::chrono::duration<double>(Budget::Clock::now() - start_).count();
    statistics_.registered_states = states_.size();
    statistics_.bytes_per_state =
        static_cast<double>(states_.memory()) / std::max(1.0, static_cast<double>(states_.size()));
    statistics_.peak_memory = peak_memory();
}

void Search::add_step(const Atoms& before, const Atoms& after, Plan& plan) {
    Change wanted;
    std::ranges::set_difference(after, before, std::back_inserter(wanted.added));
    std::ranges::set_difference(before, after, std::back_inserter(wanted.deleted));
    load(before);
    std::optional<Rational> best;
    PlanStep step;
    actions_.for_each_applicable([&](std::uint32_t schema, const ObjectNumber* arguments) {
        const Change& change = actions_.change(schema);
        if (change.added != wanted.added || change.deleted != wanted.deleted) return;
        const Rational cost = actions_.cost(schema);
        if (best && *best <= cost) return;
        best = cost;
        step.schema = SchemaId(schema);
        step.arguments.clear();
        for (std::uint32_t i = 0; i < task_.schemas[schema].scope.parameter_count; ++i)
            step.arguments.push_back(ObjectId(arguments[i]));
    });
    if (!best) return;
    plan.cost = plan.cost + *best;
    plan.steps.push_back(std::move(step));
}

void Search::extract_plan(StateNumber goal, LiftedOutcome& outcome) {
    std::vector<StateNumber> way;
    for (StateNumber state = goal; state != kNoState; state = states_.parent(state)) way.push_back(state);
    std::ranges::reverse(way);
    Plan plan;
    Atoms before, after;
    for (std::size_t i = 1; i < way.size() && !solver_.stopped(); ++i) {
        states_.read(way[i - 1], before);
        states_.read(way[i], after);
        add_step(before, after, plan);
    }
    if (plan.steps.size() + 1 != way.size()) return;
    outcome.status = Status::solved;
    outcome.plan = std::move(plan);
}

LiftedOutcome Search::run() {
    LiftedOutcome outcome;
    try {
        const StateNumber initial = start();
        StateNumber found = kNoState;
        if (goal_.impossible()) {
            outcome.status = Status::unsolvable_early;
            return outcome;
        }
        open_.push(initial, static_cast<std::uint32_t>(goal_.size()), goal_.size(), 1);
        std::uint32_t countdown = 1;
        bool go_on = true;
        while (found == kNoState && !open_.empty() && go_on) {
            const StateNumber state = open_.pop();
            if ((states_.note(state) & kExpanded) != 0) continue;
            states_.note(state) |= kExpanded;
            found = expand(state);
            go_on = !solver_.stopped();
            if (--countdown == 0) {
                countdown = 64;
                go_on = go_on && look();
            }
        }
        if (found != kNoState)
            extract_plan(found, outcome);
        else if (go_on)
            outcome.status = Status::unsolvable;
        if (outcome.status == Status::failed) outcome.status = status_of(budget_.exhausted());
    } catch (const std::bad_alloc&) {
        outcome.status = Status::out_of_memory;
    }
    fill_statistics();
    outcome.statistics = statistics_;
    return outcome;
}

}  // namespace
}  // namespace lifted

LiftedOutcome lifted_search(const LiftedTask& task, const Budget& budget, const LiftedOptions& options,
                            const std::function<void(const SearchStatistics&)>& on_progress) {
    if (!lifted::Axioms::stratified(task)) {
        LiftedOutcome outcome;
        outcome.unsupported = "the derived predicates depend on their own negation";
        return outcome;
    }
    return lifted::Search(task, budget, options, on_progress).run();
}

}  // namespace praxis
