#include "belief/offline/plan_texts.hpp"

#include "belief/offline/plan_blocks.hpp"

namespace praxis::belief {
namespace {

/// Between double quotes, for JSON and Graphviz. PDDL names have no control characters.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string result;
    for (const std::string& word : words) result += (result.empty() ? "" : between) + word;
    return result;
}

std::string where(std::uint32_t target) {
    return target == PlanBlock::kGoal ? "done" : "go to " + std::to_string(target + 1);
}

}  // namespace

std::string plan_to_text(const BeliefTask& task, const ConditionalPlan& plan) {
    std::string text;
    const std::vector<PlanBlock> blocks = plan_blocks(task, plan);
    if (blocks.empty()) return plan.size() == 0 ? "" : "; nothing to do\n";
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        text += std::to_string(i + 1) + ":\n";
        for (const std::string& action : blocks[i].actions) text += "    " + action + "\n";
        for (const PlanBlock::Choice& choice : blocks[i].choices) {
            text += "    ; ";
            if (!choice.answers.empty()) text += "if " + joined(choice.answers, ", ") + ": ";
            text += where(choice.target) + "\n";
        }
    }
    return text;
}

std::string plan_to_dot(const BeliefTask& task, const ConditionalPlan& plan) {
    std::string text =
        "digraph plan {\n"
        "  node [shape=box, style=rounded, fontname=\"sans-serif\", fontsize=11];\n"
        "  edge [fontname=\"sans-serif\", fontsize=9];\n";
    for (std::uint32_t node = 0; node < plan.size(); ++node) {
        const std::string name = "n" + std::to_string(node);
        if (plan.goal(node)) {
            text += "  " + name + " [label=\"goal\", shape=doublecircle, style=solid];\n";
            continue;
        }
        const bool start = plan.action(node) == Environment::kStart;
        text += "  " + name + " [label=" +
                quoted(start ? "start" : task.physical->operator_name(OperatorId(plan.action(node)))) +
                "];\n";
        for (const ConditionalPlan::Edge& edge : plan.edges(node)) {
            std::string label;
            for (const ConditionalPlan::Report& report : plan.reports(edge))
                label += (label.empty() ? "" : "\\n") + report_text(task, report);
            text += "  " + name + " -> n" + std::to_string(edge.target);
            // The label's line breaks are Graphviz's own; nothing else in it needs escaping.
            if (!label.empty()) text += " [label=\"" + label + "\"]";
            text += ";\n";
        }
    }
    return text + "}\n";
}

std::string plan_to_json(const BeliefTask& task, const ConditionalPlan& plan) {
    std::string text = "{\"nodes\": [";
    for (std::uint32_t node = 0; node < plan.size(); ++node) {
        text += std::string(node == 0 ? "\n" : ",\n") + "  {\"id\": " + std::to_string(node);
        if (plan.goal(node)) {
            text += ", \"goal\": true}";
            continue;
        }
        if (plan.action(node) != Environment::kStart)
            text += ", \"action\": " + quoted(task.physical->operator_name(OperatorId(plan.action(node))));
        text += ", \"edges\": [";
        bool first = true;
        for (const ConditionalPlan::Edge& edge : plan.edges(node)) {
            text += first ? "{\"if\": [" : ", {\"if\": [";
            first = false;
            bool first_report = true;
            for (const ConditionalPlan::Report& report : plan.reports(edge)) {
                const bool silent = report.value == ConditionalPlan::Report::kSilent;
                text += first_report ? "" : ", ";
                text += "{\"atom\": " + quoted(report_atom(task, report.variable)) + ", \"holds\": " +
                        (silent                       ? "null"
                         : report_holds(task, report) ? "true"
                                                      : "false") +
                        "}";
                first_report = false;
            }
            text += "], \"to\": " + std::to_string(edge.target) + "}";
        }
        text += "]}";
    }
    return text + "\n],\n\"action_nodes\": " + std::to_string(plan.action_nodes()) +
           ", \"edges\": " + std::to_string(plan.edge_count()) +
           ", \"depth\": " + std::to_string(plan.depth()) + "}\n";
}

}  // namespace praxis::belief
