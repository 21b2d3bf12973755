#include "belief/worlds.hpp"

#include <algorithm>
#include <utility>

#include "belief/initial_knowledge.hpp"

namespace praxis::belief {
namespace {

constexpr int kAttempts = 200;

/// The value at which the variable's atom does not hold.
std::int32_t false_value(const FiniteDomainTask& task, std::int32_t variable) {
    return task.is_atom({variable, 0}) ? 1 : 0;
}

std::vector<std::int32_t> open_variables(const BeliefTask& task) {
    std::vector<std::int32_t> result;
    for (std::size_t v = 0; v < task.initial_values.size(); ++v)
        if (task.initial_values[v] == BeliefTask::kUnknown) result.push_back(static_cast<std::int32_t>(v));
    return result;
}

WorldState state_of(const BeliefTask& task, const InitialKnowledge& knowledge) {
    WorldState state(task.initial_values.size());
    for (std::size_t v = 0; v < state.size(); ++v) state[v] = knowledge.value(static_cast<std::int32_t>(v));
    return state;
}

/// Visits all assignments to some variables; the clauses about them alone are then satisfied.
class Enumerator {
  public:
    Enumerator(const BeliefTask& task, const std::vector<std::int32_t>& variables, std::size_t most)
        : task_(task), variables_(variables), most_(most) {}

    /// Calls add(knowledge) for each; false if there are more than `most`.
    template <class Add>
    bool run(Add add) {
        const InitialKnowledge start(task_);
        return !start.consistent() || visit(start, 0, add);
    }

  private:
    template <class Add>
    bool visit(const InitialKnowledge& knowledge, std::size_t next, Add& add) {
        while (next < variables_.size() && knowledge.value(variables_[next]) != BeliefTask::kUnknown) ++next;
        if (next == variables_.size()) {
            add(knowledge);
            return ++count_ <= most_;
        }
        for (std::int32_t value : {0, 1}) {
            InitialKnowledge more = knowledge;
            news_.clear();
            if (more.learn({variables_[next], value}, news_) && !visit(more, next + 1, add)) return false;
        }
        return true;
    }

    const BeliefTask& task_;
    const std::vector<std::int32_t>& variables_;
    std::size_t most_;
    std::size_t count_ = 0;
    std::vector<std::int32_t> news_;
};

}  // namespace

WorldState hidden_world(const BeliefTask& task, std::size_t i) {
    WorldState state = task.initial_values;
    for (std::size_t v = 0; v < state.size(); ++v)
        if (state[v] == BeliefTask::kUnknown)
            state[v] = false_value(*task.physical, static_cast<std::int32_t>(v));
    for (const Fact& fact : task.worlds[i]) state[index(fact.variable)] = fact.value;
    for (const auto* definitions : {&task.first_definitions, &task.definitions})
        for (const GroundDefinition& definition : *definitions) definition.settle(state.data());
    return state;
}

std::optional<WorldState> sample_world(const BeliefTask& task, Random& random) {
    const InitialKnowledge start(task);
    if (!start.consistent()) return std::nullopt;
    std::vector<std::size_t> clauses(task.clauses.size());
    for (std::size_t c = 0; c < clauses.size(); ++c) clauses[c] = c;
    std::vector<std::int32_t> open = open_variables(task);
    std::vector<std::int32_t> news;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        InitialKnowledge knowledge = start;
        random.shuffle(clauses);
        random.shuffle(open);
        for (std::size_t c : clauses) {
            std::vector<Fact> choices;
            bool satisfied = false;
            for (const Fact& fact : task.clauses[c]) {
                const std::int32_t value = knowledge.value(fact.variable);
                satisfied = satisfied || value == fact.value;
                if (value == BeliefTask::kUnknown) choices.push_back(fact);
            }
            if (satisfied) continue;
            random.shuffle(choices);
            for (const Fact& fact : choices)
                if (knowledge.learn(fact, news)) break;
        }
        bool complete = true;
        for (std::int32_t variable : open) {
            if (knowledge.value(variable) != BeliefTask::kUnknown) continue;
            const auto value = static_cast<std::int32_t>(random.below(2));
            complete =
                knowledge.learn({variable, value}, news) || knowledge.learn({variable, 1 - value}, news);
            if (!complete) break;
        }
        // Unit propagation has seen every clause with all its variables.
        if (complete) return state_of(task, knowledge);
    }
    return std::nullopt;
}

std::optional<std::vector<std::int8_t>> enumerate_values(const BeliefTask& task,
                                                         const std::vector<std::int32_t>& variables,
                                                         std::size_t most) {
    std::vector<std::int8_t> rows;
    const bool all = Enumerator(task, variables, most).run([&](const InitialKnowledge& knowledge) {
        for (std::int32_t variable : variables)
            rows.push_back(static_cast<std::int8_t>(knowledge.value(variable)));
    });
    if (!all) return std::nullopt;
    return rows;
}

std::optional<std::vector<WorldState>> enumerate_worlds(const BeliefTask& task, std::size_t most) {
    std::vector<WorldState> worlds;
    const bool all = Enumerator(task, open_variables(task), most).run([&](const InitialKnowledge& knowledge) {
        worlds.push_back(state_of(task, knowledge));
    });
    if (!all) return std::nullopt;
    return worlds;
}

}  // namespace praxis::belief
