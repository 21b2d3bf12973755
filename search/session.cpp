#include "search/session.hpp"

#include <malloc.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>

#include "search/atom_index.hpp"
#include "search/lifted/lifted_search.hpp"
#include "search/plan_names.hpp"
#include "search/thread_time.hpp"

namespace praxis {
namespace {

/// The shares of time and memory that grounding may take.
constexpr double kGroundingTime = 0.4;
constexpr double kGroundingMemory = 0.5;

std::string text(const LiftedTask& task, const Atom& atom) {
    std::string result = "(" + task.predicates[atom.predicate.index()].name;
    for (ObjectId object : atom.arguments) result += " " + task.objects[object.index()].name;
    return result + ")";
}

void check(const LiftedTask& task, const Atom& atom) {
    if (!atom.predicate.valid() || atom.predicate.index() >= task.predicates.size())
        throw std::invalid_argument("unknown predicate id");
    const Predicate& predicate = task.predicates[atom.predicate.index()];
    if (atom.arguments.size() != predicate.parameters.size())
        throw std::invalid_argument("predicate '" + predicate.name + "' takes " +
                                    std::to_string(predicate.parameters.size()) + " arguments, not " +
                                    std::to_string(atom.arguments.size()));
    for (ObjectId object : atom.arguments)
        if (!object.valid() || object.index() >= task.objects.size())
            throw std::invalid_argument("unknown object id in an atom of '" + predicate.name + "'");
    for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
        const Type& type = task.types[predicate.parameters[i].index()];
        const ObjectId object = atom.arguments[i];
        if (!type.contains[object.index()])
            throw std::invalid_argument("'" + task.objects[object.index()].name + "' is not of type '" +
                                        type.name + "' in " + text(task, atom));
    }
}

void append(LiftedTask& task, const Atom& atom) {
    Relation& relation = task.initial_atoms[atom.predicate.index()];
    relation.arguments.insert(relation.arguments.end(), atom.arguments.begin(), atom.arguments.end());
    ++relation.count;
}

void remove_repeated(Relation& relation) {
    std::vector<std::size_t> order(relation.count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto less = [&](std::size_t a, std::size_t b) {
        return std::ranges::lexicographical_compare(relation.tuple(a), relation.tuple(b));
    };
    const auto equal = [&](std::size_t a, std::size_t b) {
        return std::ranges::equal(relation.tuple(a), relation.tuple(b));
    };
    std::ranges::sort(order, less);
    const auto repeated = std::unique(order.begin(), order.end(), equal);
    if (repeated == order.end()) return;
    order.erase(repeated, order.end());
    Relation unique{relation.arity, order.size(), {}};
    for (std::size_t i : order)
        unique.arguments.insert(unique.arguments.end(), relation.tuple(i).begin(), relation.tuple(i).end());
    relation = std::move(unique);
}

Formula formula_of(const GoalLiteral& literal) {
    Formula atom;
    atom.kind = Connective::atom;
    atom.predicate = literal.atom.predicate;
    for (ObjectId object : literal.atom.arguments) atom.terms.push_back(Term::object(object));
    if (!literal.negated) return atom;
    Formula negation;
    negation.kind = Connective::negation;
    negation.children.push_back(std::move(atom));
    return negation;
}

}  // namespace

struct Session::Implementation {
    Implementation(Task task, const SessionOptions& session_options)
        : original(std::move(task)), current(original), options(session_options) {}

    /// Grounds the present task. Afterwards `ground.task` is null if the budget ran out.
    void ground_now(const Budget& budget);
    /// The lifted task with the present state and goal.
    const Task& present() const;
    const AtomIndex& atoms();
    const PlanNames& names();
    /// Puts a state or goal into the query; false if the ground task cannot express it.
    bool translate_state();
    bool translate_goal();
    bool respects_mutexes();
    /// Grounding has failed: for good, if the budget itself is not exhausted.
    void give_up_grounding(const Budget& budget);
    Result plan_lifted(const Budget& budget, const Callbacks& callbacks) const;
    /// Whether the ground task can take another state or goal at all.
    bool adaptable() const {
        return ground.task && !ground.task->proved_unsolvable && !grounded_options.prune_irrelevant;
    }

    Task original;
    mutable Task current;  ///< null: state or goal changed since it was made
    SessionOptions options;
    std::optional<std::vector<Atom>> state;
    std::vector<Atom> statics;  ///< static atoms that came with a state, perhaps new ones; they stay
    std::optional<std::vector<GoalLiteral>> goal;

    GroundResult ground;
    GroundOptions grounded_options;
    Task grounded;  ///< what `ground` was made from
    int groundings = 0;
    bool state_stale = true;  ///< the ground task cannot express the present state
    bool goal_stale = true;   ///< nor the present goal
    bool too_large = false;   ///< to be grounded
    bool stale() const { return !too_large && (state_stale || goal_stale); }
    std::optional<PreparedTask> prepared;
    std::optional<AtomIndex> index;
    std::optional<PlanNames> plan_names;
    Query query;
    bool goal_impossible = false;

    std::vector<std::uint32_t> constant_seen;  ///< by entry of `index`: the last epoch it was met
    std::vector<std::uint32_t> group_seen;     ///< by mutex group
    std::uint32_t epoch = 0;
};

void Session::Implementation::ground_now(const Budget& budget) {
    state_stale = goal_stale = true;
    prepared.reset();
    index.reset();
    plan_names.reset();
    grounded = present();
    grounded_options = options.ground;
    // A session whose state or goal has changed once will see more changes.
    if (options.replanning || state || goal) grounded_options.prune_irrelevant = false;
    try {
        const Budget share =
            options.lifted_fallback ? budget.share(kGroundingTime, kGroundingMemory) : budget;
        ground = praxis::ground(*grounded, grounded_options, share);
        ++groundings;
        if (!ground.task) {
            give_up_grounding(budget);
            return;
        }
        const double start = thread_seconds();
        prepared.emplace(ground.task);
        ground.phases.push_back({"prepare", thread_seconds() - start, peak_memory(), {}});
        query = task_query(*ground.task);
    } catch (const std::bad_alloc&) {
        prepared.reset();
        ground.task.reset();
        ground.stop = Stop::memory;
        give_up_grounding(budget);
        return;
    }
    goal_impossible = false;
    state_stale = goal_stale = false;
}

void Session::Implementation::give_up_grounding(const Budget& budget) {
    if (!options.lifted_fallback) return;
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    too_large = Budget(budget).exhausted() == Stop::none;
}

Result Session::Implementation::plan_lifted(const Budget& budget, const Callbacks& callbacks) const {
    LiftedOutcome outcome = lifted_search(*present(), budget, {}, callbacks.on_progress);
    Result result;
    result.lifted = true;
    result.status = outcome.unsupported.empty() ? outcome.status : status_of(ground.stop);
    result.plan = std::move(outcome.plan);
    result.statistics = outcome.statistics;
    if (result.plan && callbacks.on_plan) callbacks.on_plan(*result.plan);
    return result;
}

const Task& Session::Implementation::present() const {
    if (current) return current;
    auto task = std::make_shared<LiftedTask>(*original);
    if (state) {
        for (std::size_t i = 0; i < task->predicates.size(); ++i)
            if (task->predicates[i].fluent) {
                task->initial_atoms[i].count = 0;
                task->initial_atoms[i].arguments.clear();
            }
        for (const Atom& atom : *state)
            if (task->predicates[atom.predicate.index()].fluent) append(*task, atom);
        for (const Atom& atom : statics) append(*task, atom);
        for (Relation& relation : task->initial_atoms) remove_repeated(relation);
    }
    if (goal) {
        task->goal_scope = {};
        task->goal = {};
        task->goal.kind = Connective::conjunction;
        for (const GoalLiteral& literal : *goal) task->goal.children.push_back(formula_of(literal));
    }
    current = std::move(task);
    return current;
}

const AtomIndex& Session::Implementation::atoms() {
    if (!index) {
        index.emplace(*grounded, *ground.task);
        constant_seen.assign(index->size(), 0);
        group_seen.assign(ground.task->mutex_groups.size(), 0);
        epoch = 0;
    }
    return *index;
}

const PlanNames& Session::Implementation::names() {
    if (!plan_names) plan_names.emplace(*grounded, *ground.task);
    return *plan_names;
}

bool Session::Implementation::translate_state() {
    const AtomIndex& known = atoms();
    const FiniteDomainTask& task = *ground.task;
    std::vector<std::int32_t> values = known.empty_values();
    std::vector<bool> set(values.size(), false);
    for (std::size_t variable = 0; variable < values.size(); ++variable)
        if (task.axiom_layers[variable] >= 0) values[variable] = task.initial_values[variable];
    ++epoch;
    std::size_t constants = 0;
    for (const Atom& atom : *state) {
        std::uint32_t number = known.find(atom.predicate, atom.arguments);
        if (number == AtomIndex::kAbsent) return false;
        if (known[number].kind == AtomIndex::Entry::Kind::constant_static) continue;
        if (known[number].kind == AtomIndex::Entry::Kind::constant_fluent) {
            constants += constant_seen[number] != epoch;
            constant_seen[number] = epoch;
            continue;
        }
        for (; number != AtomIndex::kAbsent; number = known[number].next) {
            const auto variable = static_cast<std::size_t>(known[number].fact.variable);
            if (set[variable] && values[variable] != known[number].fact.value) return false;
            values[variable] = known[number].fact.value;
            set[variable] = true;
        }
    }
    if (constants != known.constant_fluents() || std::ranges::find(values, -1) != values.end()) return false;
    query.initial_values = std::move(values);
    return respects_mutexes();
}

bool Session::Implementation::respects_mutexes() {
    for (std::size_t variable = 0; variable < query.initial_values.size(); ++variable) {
        if (ground.task->derived(static_cast<std::int32_t>(variable))) continue;
        const Fact fact{static_cast<std::int32_t>(variable), query.initial_values[variable]};
        for (std::uint32_t group : index->groups_of()[ground.task->fact_number(fact)]) {
            if (group_seen[group] == epoch) return false;
            group_seen[group] = epoch;
        }
    }
    return true;
}

bool Session::Implementation::translate_goal() {
    const AtomIndex& known = atoms();
    const FiniteDomainTask& task = *ground.task;
    std::vector<Fact> facts;
    bool impossible = false;
    for (const GoalLiteral& literal : *goal) {
        const std::uint32_t number = known.find(literal.atom.predicate, literal.atom.arguments);
        if (number == AtomIndex::kAbsent) {
            // Derived atoms that are not facts may be always true or never.
            if (original->predicates[literal.atom.predicate.index()].derived) return false;
            impossible |= !literal.negated;
        } else if (known[number].kind != AtomIndex::Entry::Kind::fact) {
            impossible |= literal.negated;
        } else if (!literal.negated) {
            facts.push_back(known[number].fact);
        } else {
            const Fact fact = known[number].fact;
            if (task.domain_sizes[static_cast<std::size_t>(fact.variable)] != 2) return false;
            facts.push_back({fact.variable, 1 - fact.value});
        }
    }
    std::ranges::sort(facts);
    facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
    for (std::size_t i = 1; i < facts.size(); ++i) impossible |= facts[i - 1].variable == facts[i].variable;
    query.goal = std::move(facts);
    goal_impossible = impossible;
    return true;
}

Session::Session(Task task, const SessionOptions& options, const Budget& budget)
    : implementation_(std::make_unique<Implementation>(std::move(task), options)) {
    implementation_->ground_now(budget);
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Result Session::plan(const Configuration& configuration, const Budget& budget, const Callbacks& callbacks) {
    Implementation& self = *implementation_;
    Result result;
    if (const Stop stop = budget.exhausted(); stop != Stop::none) {
        result.status = status_of(stop);
        return result;
    }
    if (self.stale()) self.ground_now(budget);
    if (self.stale()) {
        result.status = status_of(self.ground.stop);
        return result;
    }
    if (self.too_large) return self.plan_lifted(budget, callbacks);
    if (self.goal_impossible) {
        result.status = Status::unsolvable_early;
        return result;
    }
    SearchCallbacks inner;
    inner.on_progress = callbacks.on_progress;
    inner.on_plan = [&](std::span<const OperatorId> operators, std::int64_t cost) {
        result.plan = self.names().plan(operators, cost);
        if (callbacks.on_plan) callbacks.on_plan(*result.plan);
    };
    try {
        Outcome outcome = search(*self.prepared, self.query, configuration, budget, inner);
        result.status = outcome.status;
        result.statistics = outcome.statistics;
        result.optimal = outcome.optimal;
        if (outcome.plan) result.plan = self.names().plan(*outcome.plan, outcome.cost);
    } catch (const std::bad_alloc&) {
        result.status = Status::out_of_memory;
        result.statistics.peak_memory = peak_memory();
    }
    return result;
}

void Session::set_initial_state(const std::vector<Atom>& atoms) {
    Implementation& self = *implementation_;
    for (const Atom& atom : atoms) {
        check(*self.original, atom);
        if (self.original->predicates[atom.predicate.index()].derived)
            throw std::invalid_argument("the derived atom " + text(*self.original, atom) + " cannot be set");
    }
    self.state = atoms;
    self.current.reset();
    self.state_stale = !(self.adaptable() && self.translate_state());
    if (self.state_stale)
        for (const Atom& atom : atoms)
            if (!self.original->predicates[atom.predicate.index()].fluent) self.statics.push_back(atom);
}

void Session::set_goal(const std::vector<GoalLiteral>& goal) {
    Implementation& self = *implementation_;
    for (const GoalLiteral& literal : goal) check(*self.original, literal.atom);
    self.goal = goal;
    self.current.reset();
    self.goal_stale = !(self.adaptable() && self.translate_goal());
}

const LiftedTask& Session::task() const {
    return *implementation_->present();
}
std::shared_ptr<const FiniteDomainTask> Session::ground_task() const {
    return implementation_->ground.task;
}
bool Session::lifted() const {
    return implementation_->too_large;
}
const std::vector<PhaseStatistics>& Session::phases() const {
    return implementation_->ground.phases;
}
int Session::groundings() const {
    return implementation_->groundings;
}

}  // namespace praxis
