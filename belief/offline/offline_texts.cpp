#include "belief/offline/offline_texts.hpp"

#include <cstdio>

#include "belief/offline/plan_page.hpp"
#include "belief/offline/plan_texts.hpp"

namespace praxis::belief {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string summarise(const OfflineResult& result) {
    if (result.status != OfflineStatus::found) {
        std::string text = to_string(result.status);
        if (!result.message.empty()) text += ": " + result.message;
        return text;
    }
    std::string text = std::to_string(result.plan.action_nodes()) + " actions, at most " +
                       std::to_string(result.plan.depth()) + " in a row; cost " + number(result.costs.mean) +
                       " on average, " + number(result.costs.worst) + " at worst; executed in ";
    text +=
        (result.all_worlds ? "all " : "a sample of ") + std::to_string(result.checked) + " first states; ";
    return text + (result.optimal ? "no plan costs less" : "made by " + result.way);
}

}  // namespace

OfflineTexts offline_texts(const BeliefTask& task, const OfflineResult& result, const std::string& title) {
    OfflineTexts texts;
    texts.summary = summarise(result);
    if (result.status != OfflineStatus::found) return texts;
    texts.text = plan_to_text(task, result.plan) + "; " + texts.summary + "\n";
    texts.dot = plan_to_dot(task, result.plan);
    texts.json = plan_to_json(task, result.plan);
    texts.html = plan_to_html(task, result.plan, title, texts.summary);
    return texts;
}

}  // namespace praxis::belief
