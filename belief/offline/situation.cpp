#include "belief/offline/situation.hpp"

#include <algorithm>
#include <utility>

#include "belief/environment.hpp"

namespace praxis::belief {

std::vector<std::uint32_t> Situation::key() const {
    if (!states.empty()) return states;
    const std::uint64_t print = belief.fingerprint();
    return {static_cast<std::uint32_t>(print), static_cast<std::uint32_t>(print >> 32)};
}

bool Situations::goal(const Situation& situation) const {
    if (situation.states.empty()) return situation.belief.goal_known();
    return std::all_of(situation.states.begin(), situation.states.end(),
                       [&](StateIndex state) { return table_->goal(state); });
}

bool Situations::can(const Situation& situation, std::uint32_t action) const {
    if (situation.states.empty()) return situation.belief.can(action);
    return std::all_of(situation.states.begin(), situation.states.end(),
                       [&](StateIndex state) { return table_->applicable(state, action); });
}

std::optional<std::vector<SituationOutcome>> Situations::outcomes(const Situation& situation,
                                                                  std::uint32_t action) const {
    return situation.states.empty() ? uncounted(situation, action) : counted(situation, action);
}

/// Tells the belief what is answered and everything about single variables that the states agree in.
bool Situations::tell(Situation& situation, const std::vector<Fact>& observation) const {
    for (const Fact& fact : observation)
        if (!situation.belief.learn(fact)) return false;
    const FiniteDomainTask& physical = *task_->physical;
    const std::int32_t* const first = table_->values(situation.states.front());
    for (std::size_t v = 0; v < physical.variable_count(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (!task_->uncertain[v] || physical.derived(variable)) continue;
        const Fact fact{variable, first[v]};
        if (situation.belief.knows(fact)) continue;
        const bool common =
            std::all_of(situation.states.begin(), situation.states.end(),
                        [&](StateIndex state) { return table_->values(state)[v] == fact.value; });
        if (common && !situation.belief.learn(fact)) return false;
    }
    return true;
}

std::optional<std::vector<SituationOutcome>> Situations::counted(const Situation& situation,
                                                                 std::uint32_t action) const {
    Situation after = situation;
    if (action != Environment::kStart) {
        after.belief.act(action);
        for (StateIndex& state : after.states) state = table_->successor(state, action);
        std::sort(after.states.begin(), after.states.end());
        after.states.erase(std::unique(after.states.begin(), after.states.end()), after.states.end());
    }
    std::vector<SituationOutcome> result;
    for (Answered& part : split_by_observation(*table_, after.states, action)) {
        if (result.size() >= most_outcomes_) return std::nullopt;
        SituationOutcome& outcome = result.emplace_back(
            SituationOutcome{std::move(part.observation), {after.belief, std::move(part.states)}});
        if (!tell(outcome.situation, outcome.observation)) return std::nullopt;
    }
    return result;
}

std::optional<std::vector<SituationOutcome>> Situations::uncounted(const Situation& situation,
                                                                   std::uint32_t action) const {
    std::vector<SituationOutcome> result{{{}, situation}};
    Belief& belief = result.front().situation.belief;
    std::vector<std::pair<Fact, bool>> asked;  // whether it is certain that there is an answer
    if (action != Environment::kStart) {
        belief.act(action);
        for (const GroundReading& reading : task_->readings[action]) asked.emplace_back(reading.fact, true);
    }
    for (std::size_t s = 0; s < task_->sensors.size(); ++s) {
        const auto condition = task_->sensor_conditions[s];
        const bool impossible = std::any_of(condition.begin(), condition.end(), [&](const Fact& fact) {
            return belief.truth(fact) == Truth::known_false;
        });
        if (!impossible) asked.emplace_back(task_->sensors[s].reading.fact, belief.knows(condition));
    }
    std::erase_if(asked,
                  [&](const auto& question) { return belief.truth(question.first) != Truth::unknown; });
    std::stable_sort(asked.begin(), asked.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [fact, sure] : asked) {
        std::vector<SituationOutcome> more;
        for (SituationOutcome& outcome : result) {
            for (const std::int32_t value : {fact.value, 1 - fact.value}) {
                SituationOutcome answered = outcome;
                if (!answered.situation.belief.learn({fact.variable, value})) continue;
                answered.observation.push_back({fact.variable, value});
                more.push_back(std::move(answered));
            }
            if (!sure) more.push_back(std::move(outcome));
        }
        result = std::move(more);
        if (result.empty() || result.size() > most_outcomes_) return std::nullopt;
    }
    for (SituationOutcome& outcome : result) {
        std::vector<Fact>& facts = outcome.observation;
        std::sort(facts.begin(), facts.end());
        facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
    }
    return result;
}

}  // namespace praxis::belief
