#include "app/belief_teller.hpp"

#include <nlohmann/json.hpp>

namespace praxis::app {

using belief::Event;

void BeliefTeller::tell(const Event& event, const belief::Belief& belief) {
    if (!wants_text_ && !wants_trace_) return;
    const std::string action =
        event.action == belief::Environment::kStart
            ? ""
            : belief.compilation().belief().physical->operator_name(OperatorId(event.action));
    if (wants_trace_) tell_json(event, action, belief);
    if (!wants_text_) return;
    switch (event.kind) {
        case Event::Kind::planned:
            text_ += "; plan of " + std::to_string(event.plan.size()) + " actions (" + event.text + ")\n";
            break;
        case Event::Kind::executed:
            text_ += action + "\n";
            break;
        case Event::Kind::failed:
            text_ += "; failed: " + action + (event.text.empty() ? "" : " ") + event.text + "\n";
            break;
        case Event::Kind::supposed:
            text_ += ";   supposed: " + event.text + "\n";
            break;
        case Event::Kind::found:
            text_ += ";   found " + event.text + "\n";
            break;
        case Event::Kind::read:
            text_ += ";   read " + event.text + "\n";
            break;
        case Event::Kind::finished:
            text_ += "; " + event.text + "\n";
            break;
    }
}

void BeliefTeller::tell_json(const Event& event, const std::string& action, const belief::Belief& belief) {
    static constexpr const char* kKinds[] = {"planned",  "executed", "failed", "read",
                                             "finished", "supposed", "found"};
    const belief::BeliefTask& task = belief.compilation().belief();
    nlohmann::ordered_json line{{"world", world_}, {"event", kKinds[static_cast<int>(event.kind)]}};
    if (!action.empty()) line["action"] = action;
    if (!event.text.empty()) line["text"] = event.text;
    if (event.kind == Event::Kind::planned) {
        line["actions"] = event.plan.size();
        line["processor_seconds"] = event.seconds;
    }
    std::size_t known = 0, unknown = 0;
    for (std::size_t v = 0; v < task.uncertain.size(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (!task.uncertain[v] || task.physical->derived(variable)) continue;
        ++(belief.value(variable) == belief::BeliefTask::kUnknown ? unknown : known);
    }
    line["known"] = known;
    line["unknown"] = unknown;
    trace_ += line.dump() + "\n";
}

}  // namespace praxis::app
