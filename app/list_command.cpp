#include <string>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "search/engines/registry.hpp"

namespace praxis::app {
namespace {

std::string call_text(const ComponentDescription& component) {
    std::string text = component.name + "(";
    const char* separator = "";
    for (const OptionDescription& option : component.options) {
        text += separator + option.name;
        if (!option.default_value.empty()) text += "=" + option.default_value;
        separator = ", ";
    }
    return text + ")";
}

std::string option_text(const OptionDescription& option) {
    std::string text = "      " + option.name + " (" + to_string(option.type);
    if (!option.choices.empty()) {
        text += ":";
        for (const std::string& choice : option.choices) text += " " + choice;
    }
    return text + "): " + option.help + "\n";
}

std::string properties_text(const ComponentDescription& component) {
    std::string text;
    const auto add = [&](const char* name, const std::string& value) {
        if (value.empty()) return;
        text += text.empty() ? "      " : "; ";
        text += std::string(name) + ": " + value;
    };
    add("safe", component.safe);
    add("admissible", component.admissible);
    add("consistent", component.consistent);
    add("conditional effects", component.conditional_effects);
    add("axioms", component.axioms);
    return text.empty() ? text : text + "\n";
}

std::string components_text(ComponentKind kind, const char* title) {
    std::string text = std::string(title) + "\n";
    for (const ComponentDescription& component : list_components()) {
        if (component.kind != kind) continue;
        text += "  " + call_text(component) + "\n      " + component.summary + "\n";
        text += properties_text(component);
        for (const OptionDescription& option : component.options) text += option_text(option);
    }
    return text;
}

std::string aliases_text() {
    std::string text = "Aliases\n";
    for (const AliasDescription& alias : list_aliases())
        text +=
            "  " + alias.name + "\n      " + alias.summary + "\n      --search '" + alias.expression + "'\n";
    return text;
}

std::string text_of(const std::string& kind) {
    std::string text;
    if (kind.empty() || kind == "evaluators") text += components_text(ComponentKind::evaluator, "Evaluators");
    if (kind.empty() || kind == "engines") {
        if (!text.empty()) text += "\n";
        text += components_text(ComponentKind::engine, "Engines");
        text += "\n" + components_text(ComponentKind::open_list, "Open lists");
    }
    if (kind.empty() || kind == "aliases") {
        if (!text.empty()) text += "\n";
        text += aliases_text();
    }
    return text;
}

}  // namespace

int run_list(const ListOptions& options) {
    Run run(CommonOptions{}, "list", "", "");
    return run.execute([&]() -> Ending {
        run.set_result(text_of(options.kind));
        return {"listed", kSolved, ""};
    });
}

}  // namespace praxis::app
