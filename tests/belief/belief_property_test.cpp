// Random walks in random tasks: what the belief says against the set of all states that the world may be in.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "belief/simulated_world.hpp"
#include "parser/diagnostic.hpp"
#include "tests/belief/naive_belief.hpp"
#include "tests/belief/random_contingent.hpp"

namespace praxis::belief::test {
namespace {

using State = NaiveBelief::State;
constexpr std::size_t kMostStates = 400;
constexpr int kSteps = 12;

std::uint64_t any_seed() {
    return *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
}

/// A task that has a first state, with all of them.
struct Start {
    std::shared_ptr<const BeliefTask> task;
    std::vector<State> states;
};

std::optional<Start> start(const Texts& texts) {
    RC_LOG() << texts.domain << "\n" << texts.problem << "\n";
    Start result;
    try {
        result.task = ground(texts);
    } catch (const InputError&) {
        return std::nullopt;
    }
    result.states = NaiveBelief(*result.task).first_states();
    if (result.states.empty() || result.task->physical->proved_unsolvable) return std::nullopt;
    return result;
}

/// A walk of actions that are known to be possible, with the belief and the set of states side by side.
class Walk {
  public:
    Walk(const Start& start, std::size_t most_cases, std::uint64_t seed)
        : task_(start.task),
          naive_(*task_),
          states_(start.states),
          belief_(std::make_shared<const Compilation>(task_, CompilationOptions{most_cases})),
          random_(seed),
          world_(task_, first_world(), 0, seed) {}

    void run() {
        RC_ASSERT(belief_.consistent());
        compare("at first");
        observe(Environment::kStart);
        for (int step = 0; step < kSteps && states_.size() < kMostStates; ++step) {
            if (random_.below(3) == 0) {
                belief_.begin_plan(random_);
                compare("after begin_plan");
            }
            std::vector<std::uint32_t> possible;
            for (std::uint32_t action = 0; action < task_->operator_count(); ++action)
                if (belief_.can(action)) possible.push_back(action);
            if (possible.empty()) return;
            act(possible[random_.below(possible.size())]);
        }
    }

  private:
    WorldState first_world() {
        const std::optional<WorldState> world = sample_world(*task_, random_);
        RC_ASSERT(world.has_value());
        return *world;
    }

    void act(std::uint32_t action) {
        const std::string name = task_->physical->operator_name(OperatorId(action));
        RC_LOG() << name << "\n";
        std::set<State> next;
        for (const State& state : states_) {
            RC_ASSERT(naive_.applicable(action, state));
            for (State& successor : naive_.successors(action, state)) next.insert(std::move(successor));
        }
        states_.assign(next.begin(), next.end());
        RC_ASSERT(world_.execute(action).status == Execution::Status::done);
        belief_.act(action);
        compare("after " + name);
        observe(action);
    }

    void observe(std::uint32_t action) {
        const State truth = naive_.of(world_.state());
        RC_ASSERT(std::find(states_.begin(), states_.end(), truth) != states_.end());
        std::set<std::set<NaiveBelief::Literal>> answers;
        for (const Answer& answer : world_.observe(action)) {
            RC_ASSERT(belief_.learn(answer.fact));
            if (naive_.literal(answer.fact)) answers.insert(said(answer.fact));
        }
        for (const auto& literal : naive_.readings(action, truth)) {
            // What is certain anyway need not be told.
            const auto says = [&](const auto& answer) { return answer.contains(literal); };
            if (std::erase_if(answers, says) == 0 && !holds_everywhere(literal))
                RC_FAIL("not read: (" + naive_.atom_name(literal.first) + ")");
            // That nothing is read is no evidence, only answers are.
            std::erase_if(states_,
                          [&](const State& state) { return state[literal.first] != literal.second; });
        }
        const auto shown = naive_.model_readings(action, truth);
        std::erase_if(states_,
                      [&](const State& state) { return naive_.model_readings(action, state) != shown; });
        // What models show is read as what it depends on.
        for (const auto& answer : answers)
            for (const auto& literal : answer) RC_ASSERT(!shown.empty() && holds_everywhere(literal));
        compare("after the readings");
    }

    /// What a fact says of the atoms of its variable: one value is also that the others do not hold.
    std::set<NaiveBelief::Literal> said(Fact fact) const {
        std::set<NaiveBelief::Literal> result;
        const std::int32_t values = task_->physical->domain_sizes[static_cast<std::size_t>(fact.variable)];
        for (std::int32_t value = 0; value < values; ++value)
            if (const auto literal = naive_.literal({fact.variable, value}))
                result.emplace(literal->first, literal->second == (value == fact.value));
        return result;
    }

    bool holds_everywhere(const NaiveBelief::Literal& literal) const {
        return std::all_of(states_.begin(), states_.end(),
                           [&](const State& state) { return state[literal.first] == literal.second; });
    }

    void compare(const std::string& when) const {
        const FiniteDomainTask& physical = *task_->physical;
        const Components& components = belief_.compilation().components();
        for (std::size_t v = 0; v < physical.variable_count(); ++v) {
            bool known = false;
            for (std::int32_t value = 0; value < physical.domain_sizes[v]; ++value) {
                const Fact fact{static_cast<std::int32_t>(v), value};
                const auto literal = naive_.literal(fact);
                if (!literal) continue;
                const bool everywhere = holds_everywhere(*literal);
                const std::string text =
                    (literal->second ? "(" : "not (") + naive_.atom_name(literal->first) + ") " + when;
                if (belief_.knows(fact) && !everywhere) RC_FAIL("wrongly known: " + text);
                RC_ASSERT(belief_.truth(fact) != Truth::known_true || everywhere);
                if (components.component_of[v] != Components::kNone && everywhere && !belief_.knows(fact))
                    RC_FAIL("tracked, but not known: " + text);
                RC_ASSERT(!(known && belief_.knows(fact)));
                known = known || belief_.knows(fact);
            }
        }
        if (belief_.goal_known())
            for (const State& state : states_) RC_ASSERT(naive_.goal(state));
    }

    std::shared_ptr<const BeliefTask> task_;
    NaiveBelief naive_;
    std::vector<State> states_;
    Belief belief_;
    Random random_;
    SimulatedWorld world_;
};

void walk(const Constructs& constructs, std::size_t most_cases) {
    const std::uint64_t seed = any_seed();
    const auto begin = start(random_contingent(seed, constructs));
    if (begin) Walk(*begin, most_cases, seed).run();
}

RC_GTEST_PROP(BeliefProperties, WhatIsKnownHolds, ()) {
    walk({}, 20'000);
}

RC_GTEST_PROP(BeliefProperties, WhatIsKnownHoldsWithoutCases, ()) {
    walk({}, 0);
}

RC_GTEST_PROP(BeliefProperties, WhatIsKnownHoldsWithFewCases, ()) {
    walk({}, 3);
}

Constructs with_models() {
    Constructs constructs;
    constructs.models = true;
    constructs.derived = false;
    return constructs;
}

RC_GTEST_PROP(BeliefProperties, WhatModelsShowHolds, ()) {
    walk(with_models(), 20'000);
}

RC_GTEST_PROP(BeliefProperties, WhatModelsShowHoldsWithoutCases, ()) {
    walk(with_models(), 0);
}

}  // namespace
}  // namespace praxis::belief::test
