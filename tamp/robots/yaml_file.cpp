#include "tamp/robots/yaml_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kLargestText = std::size_t{16} << 20;
constexpr int kMostNested = 100;

/// The library recurses into what is nested, and aliases can make small texts huge.
void require_tame(const Source& source) {
    if (source.text.size() > kLargestText) fail_unplaced(source.name + ": larger than 16 MiB");
    int brackets = 0;
    std::size_t line_begin = 0;
    for (std::size_t i = 0; i < source.text.size(); ++i) {
        const char c = source.text[i];
        if (c == '[' || c == '{') ++brackets;
        if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
        if (c == '\n') line_begin = i + 1;
        const bool indicator = (c == '-' || c == '?' || c == ':') && i - line_begin > 2 * kMostNested;
        const bool deep_block = indicator && source.text.find_first_not_of(" -?:\t", line_begin) >= i;
        if (brackets > kMostNested || deep_block) {
            fail_unplaced(source.name + ": is nested more than 100 levels deep");
        }
    }
}

std::string place(const Source& source, const YAML::Mark& mark) {
    if (mark.line < 0) return source.name + ": ";
    return source.name + ':' + std::to_string(mark.line + 1) + ':' + std::to_string(mark.column + 1) + ": ";
}

}  // namespace

YamlFile::YamlFile(Source source) : source_(std::move(source)) {
    require_text(source_);
    require_tame(source_);
    try {
        root_ = YAML::Load(source_.text);
    } catch (const YAML::Exception& error) {
        fail_unplaced(place(source_, error.mark) + "this is no YAML: " + error.msg);
    }
    require_map(root_);
}

void YamlFile::fail(const YAML::Node& node, const std::string& message) const {
    fail_unplaced(place(source_, node.Mark()) + message);
}

void YamlFile::require_keys(const YAML::Node& map, std::initializer_list<const char*> keys) const {
    require_map(map);
    for (const auto& item : map) {
        const std::string key = text(item.first);
        if (std::ranges::find(keys, key) != keys.end()) continue;
        Suggestion suggestion(key);
        std::string known;
        for (const char* each : keys) {
            suggestion.consider(each);
            known += (known.empty() ? "" : ", ") + std::string(each);
        }
        fail(item.first, "unknown key " + quote(key) + "; " +
                             (suggestion.found() ? suggestion.hint() : "known are " + known));
    }
}

YAML::Node YamlFile::entry(const YAML::Node& map, const char* key) const {
    require_map(map);
    const YAML::Node found = map[key];
    if (!found) fail(map, "there must be an entry " + quote(key));
    return found;
}

std::string YamlFile::text(const YAML::Node& node) const {
    if (!node.IsScalar()) fail(node, "expected a word");
    return node.Scalar();
}

double YamlFile::number(const YAML::Node& node) const {
    const std::string word = text(node);
    double number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || stop != word.data() + word.size() || !std::isfinite(number)) {
        fail(node, quote(word) + " is no finite number");
    }
    return number;
}

std::vector<double> YamlFile::numbers(const YAML::Node& node, std::size_t size) const {
    require_list(node);
    if (node.size() != size) {
        fail(node, "expected " + std::to_string(size) + " numbers, not " + std::to_string(node.size()));
    }
    std::vector<double> numbers;
    for (const auto& item : node) numbers.push_back(number(item));
    return numbers;
}

void YamlFile::require_map(const YAML::Node& node) const {
    if (!node.IsMap()) fail(node, "expected a map of keys and values");
}

void YamlFile::require_list(const YAML::Node& node) const {
    if (!node.IsSequence()) fail(node, "expected a list");
}

}  // namespace praxis::tamp
