#include "belief/view/run_page.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "belief/offline/plan_blocks.hpp"
#include "belief/view/run_page_parts.hpp"
#include "search/text/markup.hpp"

namespace praxis::belief {
namespace {

const char* boolean(bool value) {
    return value ? "true" : "false";
}

std::string list(const std::vector<std::string>& texts) {
    std::string result = "[";
    for (const std::string& text : texts) result += (result.size() > 1 ? "," : "") + script_string(text);
    return result + "]";
}

}  // namespace

/// An atom in the table.
struct RunRecorder::Row {
    std::string name;
    Fact fact;  ///< the atom holds if this fact does
    bool goal = false;
    bool derived = false;
};

RunRecorder::RunRecorder(const Belief& start) : task_(start.compilation().shared_belief()) {
    now_.resize(task_->physical->variable_count());
    look(start);
    first_ = before_ = now_;
    steps_.emplace_back();
    const FiniteDomainTask& physical = *task_->physical;
    for (std::size_t v = 0; v < now_.size(); ++v) {
        if (!task_->uncertain[v]) continue;
        for (std::int32_t value = 0; value < physical.domain_sizes[v]; ++value) {
            const Fact fact{static_cast<std::int32_t>(v), value};
            names_[physical.fact_name(fact)] = report_text(*task_, {fact.variable, value});
        }
    }
}

std::string RunRecorder::readable(const std::string& fact) const {
    const auto found = names_.find(fact);
    return found == names_.end() ? fact : found->second;
}

void RunRecorder::look(const Belief& belief) {
    for (std::size_t v = 0; v < now_.size(); ++v) now_[v] = belief.value(static_cast<std::int32_t>(v));
}

std::vector<RunRecorder::Change> RunRecorder::differences() const {
    std::vector<Change> changes;
    for (std::size_t v = 0; v < now_.size(); ++v)
        if (now_[v] != before_[v]) changes.emplace_back(static_cast<std::int32_t>(v), now_[v]);
    return changes;
}

void RunRecorder::tell(const Event& event, const Belief& belief) {
    switch (event.kind) {
        case Event::Kind::executed:
        case Event::Kind::failed: {
            steps_.back().changes = differences();
            before_ = now_;
            Step& step = steps_.emplace_back();
            step.action = task_->physical->operator_name(OperatorId(event.action));
            step.failed = event.kind == Event::Kind::failed;
            step.failure = event.text;
            break;
        }
        case Event::Kind::read:
            steps_.back().read.push_back(readable(event.text));
            break;
        case Event::Kind::found:
            steps_.back().read.push_back("found " + event.text);
            break;
        case Event::Kind::supposed:
            steps_.back().read.push_back("supposed: " + event.text);
            break;
        case Event::Kind::planned:
            steps_.back().plans.push_back({event.text, {}});
            for (const std::uint32_t action : event.plan)
                steps_.back().plans.back().actions.push_back(
                    task_->physical->operator_name(OperatorId(action)));
            break;
        case Event::Kind::finished:
            steps_.back().end = event.text;
            break;
    }
    look(belief);
}

std::vector<RunRecorder::Row> RunRecorder::rows() const {
    const FiniteDomainTask& physical = *task_->physical;
    std::vector<std::set<std::int32_t>> seen(now_.size());
    for (std::size_t v = 0; v < now_.size(); ++v) seen[v] = {first_[v], now_[v]};
    for (const Step& step : steps_)
        for (const auto& [variable, value] : step.changes)
            seen[static_cast<std::size_t>(variable)].insert(value);
    std::map<std::int32_t, std::int32_t> goal;  // by variable: the value
    for (const Fact& fact : physical.goal) {
        goal[fact.variable] = fact.value;
        seen[static_cast<std::size_t>(fact.variable)].insert(fact.value);
    }
    std::vector<Row> result;
    for (std::size_t v = 0; v < now_.size(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        const auto wanted = goal.find(variable);
        const bool in_goal = wanted != goal.end();
        if (!in_goal && !task_->uncertain[v] && seen[v].size() == 1) continue;
        const bool derived = physical.derived(variable);
        if (physical.domain_sizes[v] == 2 &&
            !(physical.is_atom({variable, 0}) && physical.is_atom({variable, 1}))) {
            const std::int32_t value = report_holds(*task_, {variable, 1}) ? 1 : 0;
            result.push_back({report_atom(*task_, variable), {variable, value}, in_goal, derived});
            continue;
        }
        for (const std::int32_t value : seen[v]) {
            if (value == BeliefTask::kUnknown || !physical.is_atom({variable, value})) continue;
            result.push_back({report_text(*task_, {variable, value}),
                              {variable, value},
                              in_goal && wanted->second == value,
                              derived});
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Row& a, const Row& b) { return a.goal > b.goal; });
    return result;
}

std::string RunRecorder::page(const std::string& title, const std::string& summary) const {
    const std::vector<Row> table = rows();
    std::map<std::int32_t, std::vector<std::size_t>> rows_of;
    for (std::size_t i = 0; i < table.size(); ++i) rows_of[table[i].fact.variable].push_back(i);
    const auto truth = [&](const Row& row, std::int32_t value) {
        if (value == BeliefTask::kUnknown) return Truth::unknown;
        return value == row.fact.value ? Truth::known_true : Truth::known_false;
    };
    const auto code = [&](const Row& row, std::int32_t value) {
        return std::to_string(static_cast<int>(truth(row, value)));
    };

    std::string data = "{\"atoms\":[";
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Row& row = table[i];
        data += std::string(i == 0 ? "" : ",") + "\n{\"name\":" + script_string(row.name) +
                ",\"goal\":" + boolean(row.goal) + ",\"derived\":" + boolean(row.derived) +
                ",\"first\":" + code(row, first_[static_cast<std::size_t>(row.fact.variable)]) + "}";
    }
    data += "],\n\"steps\":[";
    std::vector<std::int32_t> values = first_;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        data += std::string(i == 0 ? "" : ",") + "\n{\"action\":" + script_string(step.action) +
                ",\"failed\":" + boolean(step.failed) + ",\"failure\":" + script_string(step.failure) +
                ",\"read\":" + list(step.read) + ",\"end\":" + script_string(step.end) + ",\"plans\":[";
        for (std::size_t p = 0; p < step.plans.size(); ++p)
            data += std::string(p == 0 ? "" : ",") + "{\"reason\":" + script_string(step.plans[p].reason) +
                    ",\"actions\":" + list(step.plans[p].actions) + "}";
        data += "],\"changes\":[";
        const std::vector<Change> changes = i + 1 == steps_.size() ? differences() : step.changes;
        bool none = true;
        for (const auto& [variable, value] : changes) {
            std::int32_t& old = values[static_cast<std::size_t>(variable)];
            for (std::size_t r : rows_of[variable]) {
                if (truth(table[r], old) == truth(table[r], value)) continue;
                data += std::string(none ? "" : ",") + "[" + std::to_string(r) + "," + code(table[r], value) +
                        "]";
                none = false;
            }
            old = value;
        }
        data += "]}";
    }
    data += "]}";
    return run_page_html(title, summary, data);
}

}  // namespace praxis::belief
