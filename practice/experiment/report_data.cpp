#include "practice/experiment/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "practice/experiment/curves.hpp"
#include "practice/experiment/groups.hpp"
#include "practice/experiment/number_text.hpp"
#include "search/text/markup.hpp"

namespace praxis::practice {
namespace {

std::string number(double value) {
    return std::isfinite(value) ? brief(value) : script_string(fixed(value, 0));
}

/// At most `most` of `items`, evenly spaced with both ends.
template <class Item>
std::vector<Item> thinned(const std::vector<Item>& items, std::size_t most) {
    if (items.size() <= most) return items;
    std::vector<Item> result;
    for (std::size_t i = 0; i < most; ++i)
        result.push_back(items[most == 1 ? 0 : i * (items.size() - 1) / (most - 1)]);
    return result;
}

class RunData {
  public:
    RunData(const RunResult& run, const ReportOptions& options) : run_(run), options_(options) {}

    std::string text() {
        std::vector<const PracticeChoice*> first;  // of each cycle
        for (const PracticeChoice& choice : run_.choices)
            if (first.empty() || first.back()->cycle != choice.cycle) first.push_back(&choice);
        std::string choices;
        for (const PracticeChoice* choice : thinned(first, options_.cycles_shown))
            choices += (choices.empty() ? "\n" : ",\n") + choice_text(*choice);
        const std::string name =
            run_.environment + ", " + run_.method + ", seed " + std::to_string(run_.seed);
        return "{\"name\":" + script_string(name) + ",\"cycles\":" + std::to_string(first.size()) +
               ",\"skills\":[" + skills_ + "],\"choices\":[" + choices + "]}";
    }

  private:
    std::string choice_text(const PracticeChoice& choice) {
        std::string rows;
        std::size_t shown = 0;
        for (std::size_t i = 0; i < choice.candidates.size(); ++i) {
            const CandidateScore& candidate = choice.candidates[i];
            if (i >= options_.candidates_shown && candidate.skill != choice.chosen) continue;
            rows += (shown++ == 0 ? "" : ",") + row(candidate);
        }
        return "{\"cycle\":" + std::to_string(choice.cycle) +
               ",\"transitions\":" + std::to_string(choice.transitions) +
               ",\"solved\":" + brief(solved_at(run_.curve, choice.transitions)) +
               ",\"chosen\":" + script_string(choice.chosen) +
               ",\"left\":" + std::to_string(choice.candidates.size() - shown) + ",\"rows\":[" + rows + "]}";
    }

    std::string row(const CandidateScore& candidate) {
        const auto [place, fresh] = places_.try_emplace(candidate.skill, places_.size());
        if (fresh) skills_ += (skills_.empty() ? "" : ",") + script_string(candidate.skill);
        return "[" + std::to_string(place->second) + "," + number(candidate.score) + "," +
               number(candidate.competence) + "," + number(candidate.predicted) + "," +
               number(candidate.cost) + "," + std::to_string(candidate.tries) + "," +
               std::to_string(candidate.successes) + "]";
    }

    const RunResult& run_;
    const ReportOptions& options_;
    std::map<std::string, std::size_t> places_;
    std::string skills_;
};

}  // namespace

std::string report_data(std::span<const RunResult> runs, const ReportOptions& options) {
    std::string text;
    std::size_t shown = 0;
    for (const EnvironmentGroup& environment : group_runs(runs)) {
        for (const MethodGroup& method : environment.methods) {
            std::vector<std::size_t> by_seed = method.runs;
            std::sort(by_seed.begin(), by_seed.end(),
                      [&](std::size_t a, std::size_t b) { return runs[a].seed < runs[b].seed; });
            by_seed.resize(std::min(by_seed.size(), options.runs_shown));
            for (const std::size_t run : by_seed)
                text += (shown++ == 0 ? "\n" : ",\n") + RunData(runs[run], options).text();
        }
    }
    return "{\"runs\":[" + text + "],\"left\":" + std::to_string(runs.size() - shown) + "}";
}

}  // namespace praxis::practice
