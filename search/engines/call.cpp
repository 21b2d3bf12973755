#include "search/engines/call.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "search/engines/search_plan.hpp"
#include "search/engines/syntax.hpp"

namespace praxis {

namespace {

class Checker {
  public:
    explicit Checker(std::string_view expression) : expression_(expression) {}

    Call call(const SyntaxNode& node, ComponentKind kind) {
        if (node.kind == SyntaxNode::Kind::list)
            fail(node, "expected one " + to_string(kind) + ", not a list");
        const Component& component = find(node, kind);
        if (node.kind == SyntaxNode::Kind::word) {
            fail(node, "'" + node.text + "' needs parentheses", "write '" + node.text + "()'");
        }
        const auto& options = component.description.options;
        std::vector<const SyntaxNode*> given(options.size(), nullptr);
        std::size_t position = 0;
        bool named = false;
        for (const SyntaxNode& child : node.children) {
            std::size_t option = position;
            if (!child.key.empty()) {
                named = true;
                option = option_number(component, child);
            } else if (named) {
                fail(child, "an argument without a name after one with a name");
            } else if (option == options.size()) {
                fail(child,
                     "'" + node.text + "' takes " + std::to_string(options.size()) + " arguments at most");
            }
            ++position;
            if (given[option] != nullptr) fail(child, "option '" + options[option].name + "' is given twice");
            given[option] = &child;
        }
        Call result;
        result.component = &component;
        result.canonical = component.description.name + "(";
        for (std::size_t i = 0; i < options.size(); ++i) {
            if (given[i] == nullptr && options[i].default_value.empty()) {
                fail(node, "'" + node.text + "' needs a value for '" + options[i].name + "'");
            }
            result.canonical += (i == 0 ? "" : ",") + options[i].name + "=";
            if (given[i] != nullptr) {
                result.arguments.push_back(value(*given[i], options[i], result.canonical));
            } else {
                Checker defaults(options[i].default_value);
                result.arguments.push_back(
                    defaults.value(parse_expression(options[i].default_value), options[i], result.canonical));
            }
        }
        result.canonical += ')';
        return result;
    }

    [[noreturn]] void fail(const SyntaxNode& node, const std::string& message,
                           const std::string& hint = {}) const {
        expression_error(expression_, node.offset, node.length, message, hint);
    }

  private:
    const Component& find(const SyntaxNode& node, ComponentKind kind) const {
        const Component* elsewhere = nullptr;
        std::vector<std::string> names;
        for (const Component& component : components()) {
            if (component.description.kind == kind) names.push_back(component.description.name);
            if (component.description.name != node.text) continue;
            if (component.description.kind == kind) return component;
            elsewhere = &component;
        }
        if (elsewhere != nullptr) {
            fail(node, "expected an " + to_string(kind) + ", but '" + node.text + "' is an " +
                           to_string(elsewhere->description.kind));
        }
        fail(node, "there is no " + to_string(kind) + " '" + node.text + "'", did_you_mean(node.text, names));
    }

    std::size_t option_number(const Component& component, const SyntaxNode& child) const {
        std::vector<std::string> names;
        for (const OptionDescription& option : component.description.options) names.push_back(option.name);
        const auto found = std::find(names.begin(), names.end(), child.key);
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        expression_error(expression_, child.key_offset, child.key.size(),
                         "'" + component.description.name + "' has no option '" + child.key + "'",
                         did_you_mean(child.key, names));
    }

    Argument value(const SyntaxNode& node, const OptionDescription& option, std::string& canonical) {
        Argument result;
        switch (option.type) {
            case OptionType::evaluator:
                calls(node, ComponentKind::evaluator, false, false, result, canonical);
                break;
            case OptionType::evaluators:
                calls(node, ComponentKind::evaluator, true, option.default_value.empty(), result, canonical);
                break;
            case OptionType::open_list:
                calls(node, ComponentKind::open_list, false, false, result, canonical);
                break;
            case OptionType::open_lists:
                calls(node, ComponentKind::open_list, true, option.default_value.empty(), result, canonical);
                break;
            case OptionType::engine:
                calls(node, ComponentKind::engine, false, false, result, canonical);
                break;
            case OptionType::engines:
                calls(node, ComponentKind::engine, true, option.default_value.empty(), result, canonical);
                break;
            default:
                if (node.kind != SyntaxNode::Kind::word) {
                    fail(node, "option '" + option.name + "' needs " + to_string(option.type));
                }
                scalar(node, option, result);
                canonical += node.text;
        }
        return result;
    }

    void calls(const SyntaxNode& node, ComponentKind kind, bool list, bool required, Argument& result,
               std::string& canonical) {
        if (list && node.kind == SyntaxNode::Kind::list) {
            if (node.children.empty() && required)
                fail(node, "at least one " + to_string(kind) + " is needed");
            canonical += '[';
            for (const SyntaxNode& child : node.children) {
                result.calls.push_back(call(child, kind));
                canonical += result.calls.back().canonical + ',';
            }
            canonical += ']';
        } else {
            result.calls.push_back(call(node, kind));
            canonical += list ? '[' + result.calls.back().canonical + ",]" : result.calls.back().canonical;
        }
    }

    void scalar(const SyntaxNode& node, const OptionDescription& option, Argument& result) {
        const std::string& text = node.text;
        const char* const begin = text.data();
        const char* const end = begin + text.size();
        switch (option.type) {
            case OptionType::boolean:
                if (text != "true" && text != "false")
                    fail(node, "option '" + option.name + "' is true or false");
                result.integer = text == "true" ? 1 : 0;
                break;
            case OptionType::choice: {
                const auto found = std::find(option.choices.begin(), option.choices.end(), text);
                if (found == option.choices.end()) {
                    std::string all;
                    for (const std::string& choice : option.choices)
                        all += (all.empty() ? "" : ", ") + choice;
                    fail(node, "option '" + option.name + "' is one of " + all,
                         did_you_mean(text, option.choices));
                }
                result.integer = found - option.choices.begin();
                break;
            }
            case OptionType::real: {
                char* parsed = nullptr;
                result.real = text == "infinity" ? std::numeric_limits<double>::infinity()
                                                 : std::strtod(begin, &parsed);
                if (text != "infinity" && (parsed != end || !(result.real >= 0))) {
                    fail(node, "option '" + option.name + "' needs a number that is not negative");
                }
                break;
            }
            default:
                if (text == "infinity") {
                    result.integer = kInfinity;
                } else if (const auto [parsed, error] = std::from_chars(begin, end, result.integer);
                           error != std::errc() || parsed != end) {
                    fail(node, "option '" + option.name + "' needs an integer");
                }
                if (result.integer < option.minimum || result.integer > option.maximum) {
                    fail(node, "option '" + option.name + "' is out of range",
                         result.integer < option.minimum ? "at least " + std::to_string(option.minimum)
                                                         : "at most " + std::to_string(option.maximum));
                }
        }
    }

    static std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
        const std::string closest = closest_name(word, names);
        return closest.empty() ? "" : "did you mean '" + closest + "'?";
    }

    std::string_view expression_;
};

}  // namespace

const Argument& Call::operator[](std::string_view option) const {
    const auto& options = component->description.options;
    const auto found =
        std::find_if(options.begin(), options.end(), [&](const auto& known) { return known.name == option; });
    return arguments.at(static_cast<std::size_t>(found - options.begin()));
}

Call check_expression(std::string_view expression) {
    return Checker(expression).call(parse_expression(expression), ComponentKind::engine);
}

std::string to_string(OptionType type) {
    switch (type) {
        case OptionType::integer:
            return "integer";
        case OptionType::real:
            return "number";
        case OptionType::boolean:
            return "true or false";
        case OptionType::choice:
            return "choice";
        case OptionType::evaluator:
            return "evaluator";
        case OptionType::evaluators:
            return "list of evaluators";
        case OptionType::open_list:
            return "open list";
        case OptionType::open_lists:
            return "list of open lists";
        case OptionType::engine:
            return "engine";
        case OptionType::engines:
            return "list of engines";
    }
    return {};
}

std::string to_string(ComponentKind kind) {
    switch (kind) {
        case ComponentKind::evaluator:
            return "evaluator";
        case ComponentKind::open_list:
            return "open list";
        case ComponentKind::engine:
            return "engine";
    }
    return {};
}

}  // namespace praxis
