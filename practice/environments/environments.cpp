#include "practice/environments/environments.hpp"

#include <charconv>
#include <stdexcept>

#include "practice/environments/ball_ring.hpp"
#include "practice/environments/kitchen.hpp"
#include "practice/environments/light_switch.hpp"
#include "practice/environments/playroom.hpp"
#include "search/engines/syntax.hpp"

namespace praxis::practice {

namespace {

struct Entry {
    const char* name;
    const char* description;
    const char* option;  ///< its only one; empty: none
    const char* values;  ///< of the option, in words
    const char* default_value;
    /// Null where the value of the option is wrong.
    std::unique_ptr<SimulatedEnvironment> (*make)(const std::string& value);
};

std::unique_ptr<SimulatedEnvironment> make_light_switch(const std::string& value) {
    int cells = 0;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, cells);
    if (error != std::errc() || stop != end) return nullptr;
    return std::make_unique<LightSwitch>(cells);
}

std::unique_ptr<SimulatedEnvironment> make_ball_ring(const std::string& value) {
    if (value == "raw") return std::make_unique<BallRing>(BallRing::Features::raw);
    if (value == "relative") return std::make_unique<BallRing>(BallRing::Features::relative);
    return nullptr;
}

template <class T>
std::unique_ptr<SimulatedEnvironment> make(const std::string&) {
    return std::make_unique<T>();
}

constexpr Entry kEntries[] = {
    {"light-switch", "a robot walks along a row of cells to a lamp and turns it to the level that is asked",
     "cells", "a number from 3 to 10000", "100", make_light_switch},
    {"ball-ring",
     "a ball is to rest on a table from which it rolls unless a ring holds it, which must be placed well",
     "features", "'raw' or 'relative'", "raw", make_ball_ring},
    {"kitchen", "dishes are put away and crumbs are swept into a bin", "", "", "", make<Kitchen>},
    {"playroom", "toys are cleared up, by plans in which most skills only prepare", "", "", "",
     make<Playroom>},
};

const Entry* find(const std::string& name) {
    for (const Entry& entry : kEntries)
        if (name == entry.name) return &entry;
    return nullptr;
}

[[noreturn]] void unknown_name(const std::string& name) {
    std::string message = "there is no environment '" + name + "'; there are";
    const std::vector<std::string> names = environment_names();
    for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? " " : ", ") + names[i];
    const std::string closest = closest_name(name, names);
    if (!closest.empty()) message += "; did you mean '" + closest + "'?";
    throw std::invalid_argument(message);
}

/// The value that the expression gives to the only option of an environment.
std::string option_value(const SyntaxNode& node, const Entry& entry) {
    const std::string of = std::string("environment '") + entry.name + "' ";
    if (node.children.empty()) return entry.default_value;
    if (*entry.option == '\0') throw std::invalid_argument(of + "has no options");
    const SyntaxNode& argument = node.children.front();
    if (node.children.size() > 1 || (!argument.key.empty() && argument.key != entry.option) ||
        argument.kind != SyntaxNode::Kind::word)
        throw std::invalid_argument(of + "has one option: " + entry.option + '=' + entry.default_value);
    return argument.text;
}

struct Choice {
    const Entry* entry;
    std::string value;
};

Choice parse(std::string_view expression) {
    const SyntaxNode node = parse_expression(expression);
    const Entry* entry = find(node.text);
    if (entry == nullptr) unknown_name(node.text);
    return {entry, option_value(node, *entry)};
}

std::string call(const Entry& entry, const std::string& value) {
    return std::string(entry.name) + '(' + entry.option + '=' + value + ')';
}

}  // namespace

std::vector<std::string> environment_names() {
    std::vector<std::string> names;
    for (const Entry& entry : kEntries) names.emplace_back(entry.name);
    return names;
}

std::vector<Component> environments() {
    std::vector<Component> result;
    for (const Entry& entry : kEntries) {
        const std::string option = entry.option;
        result.push_back({option.empty() ? entry.name : call(entry, entry.default_value), entry.description});
    }
    return result;
}

std::unique_ptr<SimulatedEnvironment> make_environment(std::string_view expression) {
    const auto [entry, value] = parse(expression);
    if (auto environment = entry->make(value)) return environment;
    throw std::invalid_argument(std::string("environment '") + entry->name + "': option '" + entry->option +
                                "' takes " + entry->values + ", not '" + value + "'");
}

std::string canonical_environment(std::string_view expression) {
    const auto [entry, value] = parse(expression);
    return value == entry->default_value ? entry->name : call(*entry, value);
}

}  // namespace praxis::practice
