#include "search/task/restrict.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace praxis {
namespace {

void check(const FiniteDomainTask& task, const Nogood& nogood) {
    if (nogood.events.empty()) throw std::invalid_argument("a nogood without events forbids every plan");
    for (const Event& event : nogood.events) {
        if (event.op.valid() && event.op.index() >= task.operator_count())
            throw std::invalid_argument("a nogood names an operator that the task does not have");
        std::vector<std::int32_t> variables;
        for (const Fact& fact : event.facts) {
            if (fact.variable < 0 || static_cast<std::size_t>(fact.variable) >= task.variable_count() ||
                fact.value < 0 || fact.value >= task.domain_sizes[static_cast<std::size_t>(fact.variable)])
                throw std::invalid_argument("a nogood names a fact that the task does not have");
            variables.push_back(fact.variable);
        }
        std::ranges::sort(variables);
        if (std::ranges::adjacent_find(variables) != variables.end())
            throw std::invalid_argument("a nogood asks for two values of one variable at once");
    }
}

class Restrictor {
  public:
    explicit Restrictor(const FiniteDomainTask& task)
        : task_(task), made_(std::make_shared<FiniteDomainTask>(task)) {}

    void add(const Nogood& nogood) {
        std::vector<Fact> marks;
        if (nogood.events.size() > 1)
            for (const Event& event : nogood.events) marks.push_back(mark(event));
        for (std::size_t i = 0; i < nogood.events.size(); ++i) {
            const Event& event = nogood.events[i];
            std::vector<Fact> facts = event.facts;
            bool possible = true;
            for (std::size_t j = 0; j < marks.size(); ++j) {
                if (j == i || marks[j] == marks[i]) continue;
                if (nogood.events[j].op.valid())
                    facts.push_back(marks[j]);
                else
                    possible = false;  // nothing comes after the end
            }
            if (possible) forbid(event.op, std::move(facts));
        }
    }

    std::shared_ptr<const FiniteDomainTask> finish() {
        rebuild_operators();
        return std::move(made_);
    }

  private:
    /// The fact that says that the event has happened.
    Fact mark(const Event& event) {
        if (!event.op.valid()) return {-1, 0};
        std::vector<Fact> facts = event.facts;
        std::ranges::sort(facts);
        const auto [at, is_new] = marks_.try_emplace({event.op.index(), facts}, 0);
        if (!is_new) return {at->second, 1};
        at->second = add_variable("event", -1, 0);
        std::uint32_t condition = 0;
        if (!facts.empty()) {
            condition = static_cast<std::uint32_t>(made_->conditions.size());
            made_->conditions.append(facts);
        }
        new_effects_[event.op.index()].push_back({{at->second, 1}, condition});
        return {at->second, 1};
    }

    void forbid(OperatorId op, std::vector<Fact> facts) {
        std::ranges::sort(facts);
        std::vector<Fact> open;
        for (const Fact& fact : facts) {
            const Fact* known = required(op, fact.variable);
            if (known == nullptr)
                open.push_back(fact);
            else if (known->value != fact.value)
                return;
        }
        const Fact wanted = open.empty() ? never() : not_all(open);
        if (op.valid())
            new_preconditions_[op.index()].push_back(wanted);
        else
            new_goals_.push_back(wanted);
    }

    const Fact* required(OperatorId op, std::int32_t variable) const {
        const std::span<const Fact> precondition =
            op.valid() ? task_.preconditions[op.index()] : std::span<const Fact>(task_.goal);
        const auto at = std::ranges::find(precondition, variable, &Fact::variable);
        return at == precondition.end() ? nullptr : &*at;
    }

    Fact never() {
        if (!never_) never_ = add_variable("never", -1, 0);
        return {*never_, 1};
    }

    /// A fact that holds where one of these does not.
    Fact not_all(const std::vector<Fact>& facts) {
        if (facts.size() == 1) return complement(facts.front());
        const auto [at, is_new] = derived_.try_emplace(facts, 0);
        if (is_new) {
            std::int32_t layer = -1;
            for (const Fact& fact : facts)
                layer = std::max(layer, made_->axiom_layers[static_cast<std::size_t>(fact.variable)]);
            std::vector<Fact> others;
            for (const Fact& fact : facts) others.push_back(complement(fact));
            at->second = add_variable("not-all", layer + 1, 0);
            for (const Fact& other : others) {
                made_->axioms.push_back({{at->second, 1}});
                made_->axiom_bodies.append(std::span<const Fact>(&other, 1));
            }
        }
        return {at->second, 1};
    }

    /// A fact that holds where this one does not.
    Fact complement(Fact fact) {
        const auto variable = static_cast<std::size_t>(fact.variable);
        if (made_->domain_sizes[variable] == 2) return {fact.variable, 1 - fact.value};
        const auto [at, is_new] = complements_.try_emplace(fact, 0);
        if (!is_new) return {at->second, 1};
        at->second = add_variable("not", -1, task_.initial_values[variable] == fact.value ? 0 : 1);
        for (const Change& change : changes(fact.variable)) {
            const bool gains = change.value == fact.value;
            const Fact* before = required(change.op, fact.variable);
            if (!gains && before != nullptr && before->value != fact.value) continue;
            new_effects_[change.op.index()].push_back({{at->second, gains ? 0 : 1}, change.condition});
        }
        return {at->second, 1};
    }

    /// An effect on a variable.
    struct Change {
        OperatorId op;
        std::int32_t value;
        std::uint32_t condition;
    };

    const std::vector<Change>& changes(std::int32_t variable) {
        if (changes_.empty()) {
            changes_.resize(task_.variable_count());
            for (std::size_t op = 0; op < task_.operator_count(); ++op)
                for (const GroundEffect& effect : task_.effects[op])
                    changes_[static_cast<std::size_t>(effect.fact.variable)].push_back(
                        {OperatorId(op), effect.fact.value, effect.condition});
        }
        return changes_[static_cast<std::size_t>(variable)];
    }

    std::int32_t add_variable(const std::string& name, std::int32_t layer, std::int32_t initial) {
        const auto variable = static_cast<std::int32_t>(made_->variable_count());
        made_->domain_sizes.push_back(2);
        made_->axiom_layers.push_back(layer);
        made_->initial_values.push_back(initial);
        made_->first_fact.push_back(made_->first_fact.back() + 2);
        made_->fact_names.symbols.push_back(name + "-" + std::to_string(variable));
        const auto word = static_cast<std::uint32_t>(made_->fact_names.symbols.size() - 1);
        for (int value = 0; value < 2; ++value)
            made_->fact_names.names.append(std::vector<std::uint32_t>{word});
        made_->fact_forms.push_back(FiniteDomainTask::FactForm::negated_atom);
        made_->fact_forms.push_back(FiniteDomainTask::FactForm::atom);
        return variable;
    }

    void rebuild_operators() {
        PackedLists<Fact> preconditions;
        PackedLists<GroundEffect> effects;
        std::size_t more = 0;
        for (const auto& [op, facts] : new_preconditions_) more += facts.size();
        preconditions.reserve(task_.operator_count(), task_.preconditions.total() + more);
        effects.reserve(task_.operator_count(), task_.effects.total() + marks_.size());
        std::vector<Fact> all;
        auto facts = new_preconditions_.begin();
        auto marks = new_effects_.begin();
        for (std::uint32_t op = 0; op < task_.operator_count(); ++op) {
            const auto old = task_.preconditions[op];
            if (facts != new_preconditions_.end() && facts->first == op) {
                all.assign(old.begin(), old.end());
                all.insert(all.end(), facts->second.begin(), facts->second.end());
                ++facts;
                preconditions.append(consistent(all));
            } else {
                preconditions.append(old);
            }
            for (const GroundEffect& effect : task_.effects[op]) effects.add(effect);
            if (marks != new_effects_.end() && marks->first == op) {
                for (const GroundEffect& effect : marks->second) effects.add(effect);
                ++marks;
            }
            effects.close();
        }
        new_goals_.insert(new_goals_.end(), task_.goal.begin(), task_.goal.end());
        made_->goal = consistent(new_goals_);
        made_->preconditions = std::move(preconditions);
        made_->effects = std::move(effects);
    }

    /// Sorted and without repetition; if two values of a variable are asked for, what never holds stands for
    /// them.
    std::vector<Fact>& consistent(std::vector<Fact>& facts) {
        std::ranges::sort(facts);
        facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
        const auto same = [](const Fact& a, const Fact& b) { return a.variable == b.variable; };
        if (std::ranges::adjacent_find(facts, same) != facts.end()) {
            facts.push_back(never());
            std::ranges::sort(facts);
            facts.erase(std::unique(facts.begin(), facts.end(), same), facts.end());
        }
        return facts;
    }

    const FiniteDomainTask& task_;
    std::shared_ptr<FiniteDomainTask> made_;
    std::map<std::uint32_t, std::vector<Fact>> new_preconditions_;  // by operator
    std::vector<Fact> new_goals_;
    std::map<std::uint32_t, std::vector<GroundEffect>> new_effects_;  // by operator
    std::map<std::pair<std::uint32_t, std::vector<Fact>>, std::int32_t> marks_;
    std::map<std::vector<Fact>, std::int32_t> derived_;
    std::map<Fact, std::int32_t> complements_;
    std::vector<std::vector<Change>> changes_;  // by variable
    std::optional<std::int32_t> never_;
};

}  // namespace

std::shared_ptr<const FiniteDomainTask> restrict(const FiniteDomainTask& task,
                                                 std::span<const Nogood> nogoods) {
    Restrictor restrictor(task);
    for (const Nogood& nogood : nogoods) {
        check(task, nogood);
        restrictor.add(nogood);
    }
    return restrictor.finish();
}

}  // namespace praxis
