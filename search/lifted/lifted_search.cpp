#include "search/lifted/lifted_search.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <new>
#include <utility>
#include <vector>

#include "search/engines/search_monitor.hpp"
#include "search/lifted/actions.hpp"
#include "search/lifted/axioms.hpp"
#include "search/lifted/goal.hpp"
#include "search/lifted/novelty_table.hpp"
#include "search/lifted/open_queues.hpp"
#include "search/lifted/relaxed_plan.hpp"
#include "search/lifted/state_store.hpp"

namespace praxis {

namespace lifted {
namespace {

using Atoms = std::vector<AtomNumber>;

class Search {
  public:
    Search(const LiftedTask& task, const Budget& budget, const LiftedOptions& options,
           const std::function<void(const SearchStatistics&)>& on_progress)
        : task_(task),
          budget_(budget),
          on_progress_(on_progress),
          database_(task),
          solver_(database_, budget_),
          axioms_(database_, solver_),
          actions_(database_, solver_),
          goal_(database_, solver_),
          relaxed_plan_(database_, solver_, axioms_, actions_, goal_),
          novelty_(options.pair_bits < 64 ? 0 : std::bit_floor(options.pair_bits)),
          open_(goal_.size()) {}

    LiftedOutcome run();

  private:
    // A state's note: whether it is expanded, and the number of the path its marks belong to.
    static constexpr std::uint32_t kExpanded = 1;
    std::uint32_t path_of(StateNumber state) { return states_.note(state) >> 1; }

    StateNumber start();
    /// Expands a state; returns a goal state if it is one or leads to one.
    StateNumber expand(StateNumber state);
    void load(const Atoms& atoms) {
        database_.load(atoms);
        axioms_.derive();
    }
    void apply(const Change& change);
    /// From the state that is loaded, which has fewer goals missing than any before it.
    void find_path(std::uint32_t missing);
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
    RelaxedPlan relaxed_plan_;
    NoveltyTable novelty_;
    StateStore states_;
    // The relaxed plan at present: its number, from how many goals missing, and the work put into all of
    // them.
    std::uint32_t path_ = 0, path_missing_ = 0xffffffff;
    std::size_t relaxed_actions_ = 0;
    static constexpr std::size_t kMostRelaxed = 200'000;
    OpenQueues open_;
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
    if (!goal_.impossible())
        novelty_.measure(goal_.literals_missing(initial) * (RelaxedPlan::kMost + 1), initial, initial, true);
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
    if (literals + conditions < path_missing_) find_path(literals + conditions);
    const std::uint64_t marks = path_of(state) == path_ ? states_.marks(state) : 0;
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
        if (!statistics_.best_estimate || estimate < *statistics_.best_estimate)
            statistics_.best_estimate = estimate;
        const std::uint64_t child_marks = marks | relaxed_plan_.bits(change.added);
        states_.set_marks(child, child_marks);
        states_.note(child) = path_ << 1;
        const auto made = static_cast<std::uint32_t>(std::popcount(child_marks));
        const int novelty = novelty_.measure((missing + conditions) * (RelaxedPlan::kMost + 1) + made, child_,
                                             change.added, missing != literals || child_marks != marks);
        open_.push(child, {missing + conditions, RelaxedPlan::kMost - made, novelty});
    });
    return found;
}

void Search::find_path(std::uint32_t missing) {
    path_missing_ = missing;
    ++path_;
    // In all no more work than the search itself has done, and a start.
    const std::size_t allowed = kMostRelaxed + statistics_.generated;
    if (relaxed_actions_ >= allowed) return;
    relaxed_actions_ += relaxed_plan_.explore(std::min(kMostRelaxed, allowed - relaxed_actions_));
    load(atoms_);
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
        open_.push(initial, {static_cast<std::uint32_t>(goal_.size()), 0, 1});
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
    try {
        return lifted::Search(task, budget, options, on_progress).run();
    } catch (const std::bad_alloc&) {
        LiftedOutcome outcome;
        outcome.status = Status::out_of_memory;
        return outcome;
    }
}

}  // namespace praxis
