#include "support.hpp"

#include <algorithm>
#include <limits>
#include <regex>
#include <set>

namespace praxis::practice::testing {
namespace {

/// The entities of XML, and numbers.
bool entities_are_closed(const std::string& text) {
    static const std::regex kEntity("&(amp|lt|gt|quot|#[0-9]+);");
    return std::regex_replace(text, kEntity, "").find('&') == std::string::npos;
}

bool characters_are_allowed(std::string_view text) {
    for (const char c : text)
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r') return false;
    return true;
}

std::string without_scripts(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t start = text.find("<script", at);
        if (start == std::string_view::npos) return result + std::string(text.substr(at));
        const std::size_t inside = text.find('>', start) + 1;
        const std::size_t end = text.find("</script>", inside);
        result += std::string(text.substr(at, inside - at));
        at = end;
    }
    return result;
}

/// Why the attributes of a tag are wrong, or "".
std::string attribute_error(std::string rest) {
    static const std::regex kAttribute("^\\s+([a-zA-Z][a-zA-Z0-9-]*)=\"([^\"<]*)\"");
    std::set<std::string> names;
    std::smatch match;
    while (std::regex_search(rest, match, kAttribute)) {
        if (!names.insert(match[1]).second) return "an attribute twice: " + match[1].str();
        rest = match.suffix();
    }
    return rest.find_first_not_of(" \n") == std::string::npos ? "" : "odd attributes: " + rest;
}

}  // namespace

const std::vector<std::string>& hostile_names() {
    static const std::vector<std::string> kNames = {"a,b",
                                                    "say \"so\"",
                                                    "two\nlines",
                                                    "\r\n",
                                                    "<script>alert(1)</script>",
                                                    "a&b;",
                                                    "../../etc",
                                                    "",
                                                    " space ",
                                                    "'",
                                                    "]]>",
                                                    "%41.%2E",
                                                    "\xe2\x82\xac",
                                                    "</svg><title>",
                                                    "--><!--",
                                                    "a.b.7.json"};
    return kNames;
}

RunResult example_run(const std::string& environment, const std::string& method, std::uint64_t seed,
                      int cycles, int candidates) {
    RunResult run{environment, method, seed, {}, {}, 0.25, 0.125};
    run.curve.push_back({0, 0, 0.125});
    for (int cycle = 1; cycle <= cycles; ++cycle) {
        PracticeChoice choice{cycle, 100 * (cycle - 1) + 7, "", {}};
        for (int c = 0; c < candidates; ++c)
            choice.candidates.push_back({"(place ring table" + std::to_string(c) + ")", -1.5 - c, 0.3, 0.8,
                                         4.25 + c, cycle + c, cycle});
        if (candidates > 0) {
            choice.chosen = choice.candidates[static_cast<std::size_t>(cycle % candidates)].skill;
            choice.candidates.back().score = -std::numeric_limits<double>::infinity();
        }
        run.choices.push_back(choice);
        choice.transitions += 20;  // another one in the same cycle
        choice.candidates.resize(choice.candidates.size() / 2);
        run.choices.push_back(choice);
        run.curve.push_back({cycle, 100 * cycle, 0.125 + 0.875 * cycle / cycles});
    }
    return run;
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t result = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++result;
    return result;
}

std::string xml_error(std::string_view text) {
    if (!characters_are_allowed(text)) return "a control character";
    const std::string page = without_scripts(text);
    std::vector<std::string> open;
    bool had_root = false;
    std::size_t at = page.starts_with("<!DOCTYPE html>") ? 15 : 0;
    while (at < page.size()) {
        const std::size_t start = std::min(page.find('<', at), page.size());
        const std::string between = page.substr(at, start - at);
        if (between.find('>') != std::string::npos) return "a stray '>' in: " + between;
        if (!entities_are_closed(between)) return "an open entity in: " + between;
        if (open.empty() && between.find_first_not_of(" \n") != std::string::npos)
            return "text outside of the root: " + between;
        if (start == page.size()) break;
        const std::size_t end = page.find('>', start);
        if (end == std::string::npos) return "a tag that does not end";
        std::string tag = page.substr(start + 1, end - start - 1);
        at = end + 1;
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) return "closed, but not open: " + tag;
            open.pop_back();
            continue;
        }
        const bool closed = tag.ends_with('/');
        if (closed) tag.pop_back();
        if (open.empty() && had_root) return "a second root: " + tag;
        had_root = true;
        const std::size_t name_end = std::min(tag.find_first_of(" \n"), tag.size());
        if (name_end == 0) return "a tag without a name";
        if (!entities_are_closed(tag)) return "an open entity in: " + tag;
        if (const std::string error = attribute_error(tag.substr(name_end)); !error.empty()) return error;
        if (!closed) open.push_back(tag.substr(0, name_end));
    }
    return open.empty() && had_root ? "" : "not closed";
}

}  // namespace praxis::practice::testing
