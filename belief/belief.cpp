#include "belief/belief.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace praxis::belief {

std::string to_string(const Supposition& supposed, const FiniteDomainTask& task) {
    std::string text;
    for (const Fact& fact : supposed.facts) text += (text.empty() ? "" : ", ") + task.fact_name(fact);
    return text;
}

Belief::Belief(std::shared_ptr<const Compilation> compilation)
    : compilation_(std::move(compilation)),
      axioms_(std::make_shared<AxiomEvaluator>(*compilation_->task())),
      initial_(compilation_->belief()),
      invariants_(InitialKnowledge::of_invariants(compilation_->belief())),
      derived_(compilation_->belief()),
      supposed_derived_(derived_),
      hypotheses_(compilation_->belief()),
      consistent_(initial_.consistent()),
      touched_(compilation_->belief().uncertain.size(), false),
      values_(compilation_->task()->initial_values) {
    const BeliefTask& task = compilation_->belief();
    for (std::size_t v = 0; v < touched_.size(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (!task.uncertain[v] || physical().derived(variable) || compilation_->tracked(variable)) continue;
        const std::int32_t value = initial_.value(variable);
        values_[basic(variable)] = value == BeliefTask::kUnknown ? Compilation::kNotKnown : value;
    }
    const Components& components = compilation_->components();
    for (const Component& component : components.tracked) cases_.emplace_back(task, components, component);
    exceptions_.resize(cases_.size());
    if (std::any_of(task.lasting.begin(), task.lasting.end(),
                    [](std::int64_t steps) { return steps != BeliefTask::kForever; }))
        confirmed_.assign(touched_.size(), 0);
    complete();
}

std::int32_t Belief::value(std::int32_t variable) const {
    if (physical().derived(variable)) return derived_.value(variable);
    return in_doubt(variable) ? BeliefTask::kUnknown : supposed(variable);
}

std::int32_t Belief::supposed(std::int32_t variable) const {
    const std::size_t v = index(variable);
    if (physical().derived(variable))
        return (hypotheses_.empty() ? derived_ : supposed_derived_).value(variable);
    const Components& components = compilation_->components();
    if (const std::uint32_t c = components.component_of[v]; c != Components::kNone)
        return cases_[c].value(components.column_of[v]);
    // Deduction in plans is part of what the closure of the first state finds.
    const std::int32_t value = values_[basic(variable)];
    return compilation_->belief().uncertain[v] && value == Compilation::kNotKnown ? BeliefTask::kUnknown
                                                                                  : value;
}

bool Belief::knows(std::span<const Fact> facts) const {
    return std::all_of(facts.begin(), facts.end(), [&](const Fact& fact) { return knows(fact); });
}

bool Belief::supposes(std::span<const Fact> facts) const {
    return std::all_of(facts.begin(), facts.end(), [&](const Fact& fact) { return supposes(fact); });
}

Truth Belief::truth(Fact fact) const {
    const std::int32_t now = value(fact.variable);
    if (now == BeliefTask::kUnknown) return Truth::unknown;
    return now == fact.value ? Truth::known_true : Truth::known_false;
}

std::uint64_t Belief::fingerprint() const {
    std::uint64_t result = 0xcbf29ce484222325ULL;
    const auto mix = [&](std::uint64_t value) { result = (result ^ value) * 0x100000001b3ULL; };
    for (std::size_t v = 0; v < touched_.size(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (physical().derived(variable) || compilation_->tracked(variable)) continue;
        mix(static_cast<std::uint64_t>(values_[basic(variable)]));
        if (compilation_->belief().uncertain[v]) {
            mix(touched_[v]);
            mix(static_cast<std::uint64_t>(initial_.value(variable) + 1));
        }
    }
    mix(hypotheses_.fingerprint());
    for (const Cases& cases : cases_) {
        std::uint64_t sum = 0;  // the order of cases does not matter
        for (std::size_t i = 0; i < cases.count(); ++i) {
            std::uint64_t row = 0x9e3779b97f4a7c15ULL;
            for (std::size_t column = 0; column < cases.width(); ++column)
                row = (row ^ static_cast<std::uint64_t>(cases.row(i)[column])) * 0xff51afd7ed558ccdULL;
            sum += row ^ (row >> 29);
        }
        mix(sum);
    }
    return result;
}

void Belief::touch(std::uint32_t action) {
    const BeliefTask& task = compilation_->belief();
    for (const GroundEffect& effect : physical().effects[action]) {
        const auto variable = static_cast<std::size_t>(effect.fact.variable);
        if (!task.uncertain[variable] || touched_[variable]) continue;
        const auto when = physical().conditions[effect.condition];
        touched_[variable] = std::none_of(
            when.begin(), when.end(), [&](const Fact& fact) { return truth(fact) == Truth::known_false; });
    }
    for (std::int32_t variable : task.forgotten[action]) touched_[index(variable)] = true;
}

void Belief::act(std::uint32_t action) {
    const FiniteDomainTask& compiled = *compilation_->task();
    if (!hypotheses_.empty()) {
        hypotheses_.allow(action, beside());
        settle();
    }
    touch(action);
    const std::vector<Cases::Way> ways = this->ways(action);
    hypotheses_.act(action, changeable(action), beside());
    for (Cases& cases : cases_) cases.act(action, ways);
    before_ = values_;
    for (const GroundEffect& effect : compilation_->effects(action))
        if (effect.condition == 0 || all_hold(compiled.conditions[effect.condition], before_.data()))
            values_[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    ++step_;
    if (!confirmed_.empty()) {
        for (const GroundEffect& effect : physical().effects[action])
            if (effect.condition == 0) confirmed_[static_cast<std::size_t>(effect.fact.variable)] = step_;
        decay();
    }
    settle();
}

/// What has not been confirmed for too long is not known any more.
void Belief::decay() {
    const std::vector<std::int64_t>& lasting = compilation_->belief().lasting;
    for (std::size_t v = 0; v < lasting.size(); ++v) {
        if (lasting[v] == BeliefTask::kForever || step_ - confirmed_[v] <= lasting[v]) continue;
        touched_[v] = true;
        hypotheses_.forget(static_cast<std::int32_t>(v));
        values_[basic(static_cast<std::int32_t>(v))] = Compilation::kNotKnown;
    }
}

bool Belief::learn(Fact fact) {
    const BeliefTask& task = compilation_->belief();
    if (!confirmed_.empty()) confirmed_[static_cast<std::size_t>(fact.variable)] = step_;
    if (in_doubt(fact.variable)) {
        hypotheses_.learn(fact);
        settle();
    }
    if (knows(fact)) return true;
    const auto variable = static_cast<std::size_t>(fact.variable);
    if (truth(fact) == Truth::known_false || !task.uncertain[variable]) return false;
    const Components& components = compilation_->components();
    if (const std::uint32_t c = components.component_of[variable]; c != Components::kNone) {
        const std::uint32_t column = components.column_of[variable];
        if (!cases_[c].keep(column, fact.value)) return false;
        const CompiledComponent& slots = compilation_->slots()[c];
        for (std::size_t slot = 0; slot < slots.possible.size(); ++slot)
            if (values_[static_cast<std::size_t>(slots.values[slot][column])] != fact.value)
                values_[static_cast<std::size_t>(slots.possible[slot])] = 0;
    } else if (touched_[variable]) {
        if (!learn_now(fact)) return false;
    } else {
        news_.clear();
        if (!initial_.learn(fact, news_, true)) return false;
        for (std::int32_t other : news_)
            if (!touched_[static_cast<std::size_t>(other)] && !compilation_->tracked(other))
                values_[basic(other)] = initial_.value(other);
    }
    complete();
    return true;
}

std::optional<Supposition> Belief::fail(std::uint32_t action) {
    touch(action);
    const std::vector<Cases::Way> ways = this->ways(action);
    hypotheses_.fail(action, changeable(action), beside());
    for (Cases& cases : cases_) {
        Cases after = cases;
        after.act(action, ways);
        cases.unite(after);
    }
    ++step_;
    if (!confirmed_.empty()) decay();
    settle();
    Supposition supposed = supposition();
    if (supposed.facts.empty()) return std::nullopt;
    return supposed;
}

std::optional<Supposition> Belief::refuse(std::uint32_t action) {
    if (!hypotheses_.refuse(action, beside())) return std::nullopt;
    settle();
    return supposition();
}

std::optional<Supposition> Belief::suppose_otherwise() {
    if (hypotheses_.empty()) return std::nullopt;
    hypotheses_.turn();
    settle();
    return supposition();
}

KnownBeside Belief::beside() const {
    return [this](std::int32_t variable) { return supposed(variable); };
}

std::vector<std::int32_t> Belief::changeable(std::uint32_t action) const {
    const auto forgotten = compilation_->belief().forgotten[action];
    std::vector<std::int32_t> variables(forgotten.begin(), forgotten.end());
    for (const GroundEffect& effect : physical().effects[action]) variables.push_back(effect.fact.variable);
    std::erase_if(variables, [&](std::int32_t variable) { return compilation_->tracked(variable); });
    return variables;
}

std::vector<Cases::Way> Belief::ways(std::uint32_t action) {
    std::vector<Cases::Way> result;
    if (cases_.empty()) return result;
    const auto precondition = physical().preconditions[action];
    const auto add = [&](Hypothesis& hypothesis) {
        Cases::Way way;
        for (const GroundEffect& effect : physical().effects[action]) {
            const auto condition = physical().conditions[effect.condition];
            way.push_back(std::all_of(condition.begin(), condition.end(), [&](const Fact& fact) {
                return compilation_->tracked(fact.variable) ||
                       std::find(precondition.begin(), precondition.end(), fact) != precondition.end() ||
                       hypothesis.value(fact.variable) == fact.value;
            }));
        }
        if (std::find(result.begin(), result.end(), way) == result.end()) result.push_back(std::move(way));
    };
    // Those count that allow the action; all of them, if none does.
    for (const bool allowed : {true, false})
        if (result.empty())
            hypotheses_.for_each(beside(), [&](Hypothesis& hypothesis) {
                if (hypothesis.allows(action) == allowed) add(hypothesis);
            });
    return result;
}

void Belief::settle() {
    if (!hypotheses_.empty()) {
        for (const Fact& fact : hypotheses_.settle())
            values_[basic(fact.variable)] =
                fact.value == BeliefTask::kUnknown ? Compilation::kNotKnown : fact.value;
        for (const std::int32_t variable : hypotheses_.variables())
            values_[basic(variable)] = Compilation::kNotKnown;
        for (const Fact& fact : supposition().facts) values_[basic(fact.variable)] = fact.value;
    }
    complete();
}

bool Belief::learn_now(Fact fact) {
    if (invariants_.empty()) {
        values_[basic(fact.variable)] = fact.value;
        return true;
    }
    std::vector<std::int32_t> known(touched_.size());
    for (std::size_t v = 0; v < known.size(); ++v) known[v] = value(static_cast<std::int32_t>(v));
    InitialKnowledge now = invariants_.with(std::move(known));
    news_.clear();
    if (!now.learn(fact, news_, true)) return false;
    for (std::int32_t other : news_)
        if (touched_[static_cast<std::size_t>(other)] && !compilation_->tracked(other))
            values_[basic(other)] = now.value(other);
    return true;
}

Supposition Belief::supposition() const {
    Supposition result;
    for (std::size_t i = 0; i < hypotheses_.variables().size(); ++i) {
        const std::int32_t variable = hypotheses_.variables()[i];
        if (!compilation_->belief().uncertain[index(variable)])
            result.facts.push_back({variable, hypotheses_.supposed()[i]});
    }
    return result;
}

void Belief::begin_plan(Random& random) {
    // What could be read after the last action has been read.
    if (const std::int32_t moment = compilation_->moment(); moment >= 0)
        values_[static_cast<std::size_t>(moment)] = 0;
    for (std::size_t c = 0; c < cases_.size(); ++c) {
        const Cases& cases = cases_[c];
        const CompiledComponent& slots = compilation_->slots()[c];
        std::vector<std::size_t> order(cases.count());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        if (order.size() > slots.possible.size()) {
            random.shuffle(order);
            const std::vector<std::int8_t>& wanted = exceptions_[c];
            for (std::size_t i = 0; i < order.size() && !wanted.empty(); ++i)
                if (std::equal(wanted.begin(), wanted.end(), cases.row(order[i])))
                    std::swap(order[0], order[i]);
        }
        for (std::size_t slot = 0; slot < slots.possible.size(); ++slot) {
            const bool used = slot < order.size();
            values_[static_cast<std::size_t>(slots.possible[slot])] = used;
            const std::int8_t* const row = cases.row(order[used ? slot : 0]);
            for (std::size_t column = 0; column < slots.values[slot].size(); ++column)
                values_[static_cast<std::size_t>(slots.values[slot][column])] = row[column];
        }
        exceptions_[c].clear();
    }
    if (!cases_.empty()) complete();
}

void Belief::remember_exception(std::uint32_t action) {
    const Components& components = compilation_->components();
    for (const Fact& fact : physical().preconditions[action]) {
        const auto variable = static_cast<std::size_t>(fact.variable);
        const std::uint32_t c = components.component_of[variable];
        if (c == Components::kNone || knows(fact)) continue;
        const std::size_t i = cases_[c].exception(components.column_of[variable], fact.value);
        exceptions_[c].assign(cases_[c].row(i), cases_[c].row(i) + cases_[c].width());
    }
}

void Belief::complete() {
    const FiniteDomainTask& compiled = *compilation_->task();
    for (std::size_t v = 0; v < values_.size(); ++v)
        if (compiled.derived(static_cast<std::int32_t>(v))) values_[v] = compiled.initial_values[v];
    for (const CompiledClause& clause : compilation_->clauses()) {
        std::int32_t& closed = values_[static_cast<std::size_t>(clause.variable)];
        if (closed == 0 && std::any_of(clause.about.begin(), clause.about.end(), [&](std::int32_t variable) {
                return touched_[static_cast<std::size_t>(variable)];
            }))
            closed = 1;
    }
    axioms_->complete(values_.data(), scratch_);
    if (!physical().has_axioms()) return;
    derived_.update([&](std::int32_t variable) { return value(variable); });
    if (!hypotheses_.empty())
        supposed_derived_.update([&](std::int32_t variable) { return supposed(variable); });
}

}  // namespace praxis::belief
