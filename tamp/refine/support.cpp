#include "tamp/refine/support.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace praxis::tamp {

using validation::Condition;
using validation::Evaluator;
using Kind = Condition::Kind;

SupportRules::SupportRules(const LiftedTask& task, const std::vector<bool>& certified)
    : task_(task), certified_(certified), touches_(certified), rules_(task.predicates.size()) {
    for (const Axiom& axiom : task.axioms)
        rules_[axiom.predicate.index()].push_back({&axiom, validation::compile(axiom.body), {}});
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t p = 0; p < rules_.size(); ++p) {
            const bool now =
                std::ranges::any_of(rules_[p], [&](const Rule& rule) { return touches(rule.body); });
            if (!now || touches_[p]) continue;
            touches_[p] = changed = true;
        }
    }
    refuse_recursion();
    for (std::vector<Rule>& rules : rules_)
        for (Rule& rule : rules) rule.relaxed = relaxed(rule.body);
    for (const Schema& schema : task.schemas)
        preconditions_.push_back(validation::compile(schema.precondition));
    goal_ = validation::compile(task.goal);
}

void SupportRules::refuse_recursion() const {
    std::vector<PredicateId> used;
    for (std::size_t p = 0; p < rules_.size(); ++p) {
        if (certified_[p] || !touches_[p]) continue;
        std::vector<bool> reached(rules_.size(), false);
        std::vector<std::size_t> open{p};
        while (!open.empty()) {
            const std::size_t next = open.back();
            open.pop_back();
            for (const Rule& rule : rules_[next]) {
                used.clear();
                validation::collect_predicates(rule.body, used);
                for (const PredicateId other : used) {
                    if (reached[other.index()] || !touches_[other.index()]) continue;
                    reached[other.index()] = true;
                    open.push_back(other.index());
                }
            }
        }
        if (!reached[p]) continue;
        throw UnsupportedError("the derived predicate '" + task_.predicates[p].name +
                               "' depends on itself and on what streams certify");
    }
}

bool SupportRules::touches(const Condition& condition) const {
    if (condition.kind == Kind::atom) return touches(condition.predicate);
    return std::ranges::any_of(condition.children, [&](const Condition& child) { return touches(child); });
}

Condition SupportRules::relaxed(const Condition& condition) const {
    Condition result = condition;
    const bool gives =
        condition.kind == Kind::none ||
        (condition.kind == Kind::atom && (condition.positive ? !certified(condition.predicate) : true));
    if (gives && touches(condition)) {
        result = {};
        result.kind = Kind::truth;
        return result;
    }
    for (Condition& child : result.children) child = relaxed(child);
    return result;
}

namespace {

class SupportFinder {
  public:
    SupportFinder(const SupportRules& rules, validation::Executor& state, std::vector<Support>& supports)
        : rules_(rules), state_(state), supports_(supports) {}

    /// The variables of a scope and what they stand for; kUnbound where nothing.
    struct Frame {
        const Scope* scope;
        std::vector<std::uint32_t> values;
    };

    /// The condition holds; finds what it relies on.
    void must_hold(const Condition& condition, Frame& frame) {
        if (!rules_.touches(condition)) return;
        switch (condition.kind) {
            case Kind::atom:
                return atom_must_hold(condition, frame);
            case Kind::all:
                for (const Condition& child : condition.children) must_hold(child, frame);
                return;
            case Kind::any:
                return one_must_hold(condition, frame);
            case Kind::exists:
                return first_must_hold(condition.children.front(), condition.variables, frame, 0);
            case Kind::none:
                return none_may_hold(rules_.relaxed(condition.children.front()), condition.children.front(),
                                     condition.variables, frame);
            default:
                return;
        }
    }

  private:
    GroundAtom ground(const Condition& atom, const Frame& frame) const {
        GroundAtom result{atom.predicate.index()};
        for (const Term term : atom.terms)
            result.push_back(term.is_variable() ? frame.values[term.variable_index()]
                                                : term.object_id().index());
        return result;
    }

    void atom_must_hold(const Condition& condition, Frame& frame) {
        if (condition.positive && rules_.certified(condition.predicate)) {
            supports_.push_back({ground(condition, frame), because_, choices_ > 0});
            return;
        }
        derived_must(condition, ground(condition, frame), condition.positive);
    }

    void derived_must(const Condition& condition, const GroundAtom& atom, bool hold) {
        bool found = false;
        for (const SupportRules::Rule& rule : rules_.rules(condition.predicate)) {
            Frame inner{&rule.axiom->scope, {}};
            inner.values.assign(rule.axiom->scope.variable_types.size(), Evaluator::kUnbound);
            if (!unify(*rule.axiom, atom, inner)) continue;
            if (!hold) {
                none_may_hold(rule.relaxed, rule.body, {}, inner);
            } else if (!found && holds(rule.body, inner)) {
                found = true;
                const int more = rules_.rules(condition.predicate).size() > 1 ? 1 : 0;
                first_must_hold(rule.body, {}, inner, more);
            }
        }
    }

    bool unify(const Axiom& axiom, const GroundAtom& atom, Frame& frame) const {
        for (std::uint32_t i = 0; i < axiom.scope.parameter_count; ++i) {
            const Type& type = rules_.task().types[axiom.scope.variable_types[i].index()];
            if (!type.contains[atom[i + 1]]) return false;
            frame.values[i] = atom[i + 1];
        }
        return true;
    }

    bool holds(const Condition& condition, const Frame& frame) {
        prepare(condition, frame);
        return state_.evaluator().holds(condition);
    }

    void prepare(const Condition& condition, const Frame& frame) {
        state_.derived().update(state_.derived().components_for(condition));
        state_.evaluator().enter(*frame.scope);
        for (std::uint32_t v = 0; v < frame.values.size(); ++v)
            if (frame.values[v] != Evaluator::kUnbound) state_.evaluator().bind(v, frame.values[v]);
    }

    /// Values of `variables` and of the outermost existential, one solution after the other.
    std::vector<std::vector<std::uint32_t>> solutions(const Condition& condition,
                                                      const std::vector<std::uint32_t>& variables,
                                                      const Frame& frame, std::size_t most) {
        prepare(condition, frame);
        std::set<std::vector<std::uint32_t>> found;
        std::vector<std::vector<std::uint32_t>> result;
        const Condition* only = &condition;
        if (!state_.evaluator().inhabited(variables)) return result;
        state_.evaluator().enumerate({&only, 1}, variables, [&] {
            std::vector<std::uint32_t> values;
            for (const std::uint32_t variable : variables)
                values.push_back(state_.evaluator().value(variable));
            if (found.insert(values).second) result.push_back(std::move(values));
            return result.size() >= most;
        });
        return result;
    }

    void one_must_hold(const Condition& condition, Frame& frame) {
        const Condition* first = nullptr;
        int more = -1;
        for (const Condition& child : condition.children) {
            if (!holds(child, frame)) continue;
            ++more;
            if (first == nullptr || (rules_.touches(*first) && !rules_.touches(child))) first = &child;
        }
        if (first == nullptr) return;
        const Reasons before = reasons();
        choices_ += more;
        must_hold(*first, frame);
        restore(before);
    }

    /// The first solution counts; what makes it one are its reasons.
    void first_must_hold(const Condition& body, const std::vector<std::uint32_t>& variables, Frame& frame,
                         int choices) {
        if (body.kind == Kind::exists && variables.empty())
            return first_must_hold(body.children.front(), body.variables, frame, choices);
        const auto found = solutions(body, variables, frame, 2);
        if (found.empty()) return;
        bind(variables, found.front(), frame);
        const Reasons before = reasons();
        add_reasons(body, nullptr, frame);
        choices_ += choices + (found.size() > 1 ? 1 : 0);
        must_hold(body, frame);
        restore(before);
        unbind(variables, frame);
    }

    /// No solution of `body` may hold; `relaxed` are those that only certified atoms keep from it.
    void none_may_hold(const Condition& relaxed, const Condition& body,
                       const std::vector<std::uint32_t>& variables, Frame& frame) {
        if (body.kind == Kind::exists && variables.empty()) {
            return none_may_hold(relaxed.children.front(), body.children.front(), body.variables, frame);
        }
        for (const auto& values : solutions(relaxed, variables, frame, SIZE_MAX)) {
            bind(variables, values, frame);
            const Reasons before = reasons();
            must_fail(body, frame);
            restore(before);
            unbind(variables, frame);
        }
    }

    /// The condition does not hold, but would if nothing were certified.
    void must_fail(const Condition& condition, Frame& frame) {
        if (!rules_.touches(condition)) return;
        switch (condition.kind) {
            case Kind::atom:
                if (rules_.certified(condition.predicate) && !condition.positive)
                    supports_.push_back({ground(condition, frame), because_, choices_ > 0});
                else if (!rules_.certified(condition.predicate))
                    derived_must(condition, ground(condition, frame), !condition.positive);
                return;
            case Kind::all: {
                std::vector<const Condition*> ways;
                for (const Condition& child : condition.children)
                    if (rules_.touches(child)) ways.push_back(&child);
                add_reasons(condition, ways.front(), frame);
                choices_ += static_cast<int>(ways.size()) - 1;
                return must_fail(*ways.front(), frame);
            }
            case Kind::any:
                for (const Condition& child : condition.children)
                    if (holds(rules_.relaxed(child), frame)) must_fail(child, frame);
                return;
            case Kind::exists:
                return none_may_hold(rules_.relaxed(condition.children.front()), condition.children.front(),
                                     condition.variables, frame);
            case Kind::none:
                return first_must_hold(condition.children.front(), condition.variables, frame, 1);
            default:
                return;
        }
    }

    struct Reasons {
        std::size_t because;
        int choices;
    };
    Reasons reasons() const { return {because_.size(), choices_}; }
    void restore(Reasons before) {
        because_.resize(before.because);
        choices_ = before.choices;
    }

    /// The state's atoms that a conjunction has beside `except`. Where there are other reasons than atoms
    /// that hold, it counts as a choice: what is learned from it is not the whole truth.
    void add_reasons(const Condition& condition, const Condition* except, const Frame& frame) {
        if (&condition == except) return;
        if (condition.kind == Kind::all) {
            for (const Condition& child : condition.children) add_reasons(child, except, frame);
            return;
        }
        if (condition.kind == Kind::truth || condition.kind == Kind::equality) return;
        if (condition.kind != Kind::atom) {
            if (!rules_.touches(condition)) ++choices_;
            return;
        }
        const Predicate& predicate = rules_.task().predicates[condition.predicate.index()];
        if (rules_.touches(condition.predicate) || (!predicate.fluent && !predicate.derived)) return;
        if (condition.positive)
            because_.push_back(ground(condition, frame));
        else
            ++choices_;
    }

    void bind(const std::vector<std::uint32_t>& variables, const std::vector<std::uint32_t>& values,
              Frame& frame) const {
        for (std::size_t i = 0; i < variables.size(); ++i) frame.values[variables[i]] = values[i];
    }
    void unbind(const std::vector<std::uint32_t>& variables, Frame& frame) const {
        for (const std::uint32_t variable : variables) frame.values[variable] = Evaluator::kUnbound;
    }

    const SupportRules& rules_;
    validation::Executor& state_;
    std::vector<Support>& supports_;
    std::vector<GroundAtom> because_;
    int choices_ = 0;
};

}  // namespace

void find_supports(const SupportRules& rules, validation::Executor& state, const PlanStep& step,
                   std::vector<Support>& supports) {
    const Scope& scope = rules.task().schemas[step.schema.index()].scope;
    SupportFinder::Frame frame{&scope, {}};
    frame.values.assign(scope.variable_types.size(), Evaluator::kUnbound);
    for (std::size_t i = 0; i < step.arguments.size(); ++i) frame.values[i] = step.arguments[i].index();
    SupportFinder(rules, state, supports).must_hold(rules.precondition(step.schema), frame);
}

void find_goal_supports(const SupportRules& rules, validation::Executor& state,
                        std::vector<Support>& supports) {
    const Scope& scope = rules.task().goal_scope;
    SupportFinder::Frame frame{&scope, {}};
    frame.values.assign(scope.variable_types.size(), Evaluator::kUnbound);
    SupportFinder(rules, state, supports).must_hold(rules.goal(), frame);
}

}  // namespace praxis::tamp
