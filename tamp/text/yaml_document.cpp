#include "tamp/text/yaml_document.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kLargestDocument = std::size_t{64} << 20;

[[noreturn]] void fail_at(const Sources& sources, const YAML::Mark& mark, std::size_t length,
                          const std::string& message, const std::string& hint) {
    Diagnostic diagnostic;
    diagnostic.placed = !mark.is_null();
    diagnostic.where.offset = static_cast<std::uint32_t>(std::max(mark.pos, 0));
    diagnostic.where.length = static_cast<std::uint32_t>(length);
    diagnostic.message = message;
    diagnostic.hint = hint;
    throw InputError(to_string(diagnostic, sources), {diagnostic});
}

const char* kind_of(const YAML::Node& node) {
    switch (node.Type()) {
        case YAML::NodeType::Map:
            return "a map";
        case YAML::NodeType::Sequence:
            return "a list";
        case YAML::NodeType::Scalar:
            return "a plain value";
        case YAML::NodeType::Null:
        case YAML::NodeType::Undefined:
            break;
    }
    return "nothing";
}

}  // namespace

bool is_given(const YAML::Node& node) {
    return node.IsDefined() && !node.IsNull() && !(node.IsSequence() && node.size() == 0);
}

YamlDocument::YamlDocument(Source source) {
    require_text(source);
    if (source.text.size() > kLargestDocument) fail_unplaced(source.name + ": larger than 64 MiB");
    sources_.files.push_back(std::move(source));
    try {
        const std::vector<YAML::Node> documents = YAML::LoadAll(sources_.files[0].text);
        if (documents.size() != 1) {
            fail_unplaced(name() + ": must hold one YAML document, not " + std::to_string(documents.size()));
        }
        root_ = documents.front();
    } catch (const YAML::Exception& error) {
        fail_at(sources_, error.mark, 1, "this is no YAML: " + error.msg, {});
    }
    require_map(root_, "the file");
}

void YamlDocument::fail(const YAML::Node& at, const std::string& message, const std::string& hint) const {
    fail_at(sources_, at.Mark(), at.IsScalar() ? at.Scalar().size() : 1, message, hint);
}

void YamlDocument::require_map(const YAML::Node& node, const std::string& what) const {
    if (!node.IsMap()) fail(node, what + " must be a map (key: value), not " + kind_of(node));
}

void YamlDocument::require_list(const YAML::Node& node, const std::string& what) const {
    if (!node.IsSequence()) fail(node, what + " must be a list, not " + kind_of(node));
}

void YamlDocument::require_keys(const YAML::Node& map, const std::string& what,
                                std::initializer_list<std::string_view> known) const {
    require_map(map, what);
    std::set<std::string> seen;
    for (const auto& item : map) {
        const std::string key = text(item.first, "a key of " + what);
        if (!seen.insert(key).second) fail(item.first, what + " has the key " + quote(key) + " twice");
        if (std::ranges::find(known, key) != known.end()) continue;
        Suggestion suggestion(key);
        std::string list;
        for (const std::string_view candidate : known) {
            suggestion.consider(candidate);
            list += (list.empty() ? "" : ", ") + std::string(candidate);
        }
        fail(item.first, what + " has no key " + quote(key),
             suggestion.found() ? suggestion.hint() : "known keys: " + list);
    }
}

YAML::Node YamlDocument::find(const YAML::Node& node, const char* key) {
    return node.IsDefined() && node.IsMap() ? node[key] : YAML::Node(YAML::NodeType::Undefined);
}

YAML::Node YamlDocument::member(const YAML::Node& map, const char* key, const std::string& what) const {
    require_map(map, what);
    YAML::Node value = map[key];
    if (!value.IsDefined()) fail(map, what + " needs '" + std::string(key) + "'");
    return value;
}

double YamlDocument::number(const YAML::Node& node, const std::string& what) const {
    if (!node.IsScalar()) fail(node, what + " must be a number, not " + kind_of(node));
    std::string_view digits = node.Scalar();
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
        fail(node, what + " must be a finite number, not " + quote(node.Scalar()));
    }
    return value;
}

double YamlDocument::length(const YAML::Node& node, const std::string& what) const {
    const double value = number(node, what);
    if (value <= 0) fail(node, what + " must be above 0");
    return value;
}

std::vector<double> YamlDocument::numbers(const YAML::Node& node, const std::string& what,
                                          std::size_t count) const {
    require_list(node, what);
    if (node.size() != count) {
        fail(node,
             what + " must have " + std::to_string(count) + " numbers, not " + std::to_string(node.size()));
    }
    std::vector<double> values;
    values.reserve(count);
    for (const YAML::Node& item : node) values.push_back(number(item, what));
    return values;
}

Vector3 YamlDocument::vector(const YAML::Node& node, const std::string& what) const {
    const std::vector<double> values = numbers(node, what, 3);
    return {values[0], values[1], values[2]};
}

bool YamlDocument::boolean(const YAML::Node& node, const std::string& what) const {
    if (node.IsScalar() && node.Scalar() == "true") return true;
    if (node.IsScalar() && node.Scalar() == "false") return false;
    fail(node, what + " must be true or false");
}

std::string YamlDocument::text(const YAML::Node& node, const std::string& what) const {
    if (!node.IsScalar()) fail(node, what + " must be a text, not " + kind_of(node));
    if (node.Scalar().find_first_not_of(" \t\r\n") == std::string::npos) fail(node, what + " is blank");
    return node.Scalar();
}

std::vector<std::string> YamlDocument::texts(const YAML::Node& node, const std::string& what) const {
    require_list(node, what);
    std::vector<std::string> values;
    values.reserve(node.size());
    for (const YAML::Node& item : node) values.push_back(text(item, what));
    return values;
}

}  // namespace praxis::tamp
