#include "belief/perception/json_answer.hpp"

#include <set>
#include <vector>

namespace praxis::belief {
namespace {

using Json = nlohmann::json;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string_view without_fence(std::string_view text) {
    text = trimmed(text);
    if (!text.starts_with("```") || !text.ends_with("```") || text.size() < 6) return text;
    text = text.substr(3, text.size() - 6);
    const std::size_t line = text.find('\n');
    if (line == std::string_view::npos) return trimmed(text);
    const std::string_view language = trimmed(text.substr(0, line));
    return trimmed(language.empty() || language == "json" ? text.substr(line + 1) : text);
}

}  // namespace

Json read_json_answer(std::string_view text, std::string& why) {
    std::vector<std::set<std::string>> members;
    std::string twice;
    const Json::parser_callback_t watch = [&](int, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::object_start) members.emplace_back();
        if (event == Json::parse_event_t::object_end) members.pop_back();
        if (event == Json::parse_event_t::key &&
            !members.back().insert(value.get_ref<const std::string&>()).second) {
            twice = value.get_ref<const std::string&>();
        }
        return true;
    };
    Json result;
    try {
        result = Json::parse(without_fence(text), watch);
    } catch (const Json::exception& error) {
        why = std::string("not JSON: ") + error.what();
        return Json(Json::value_t::discarded);
    }
    if (!twice.empty()) {
        why = "the member \"" + twice + "\" is there twice";
        return Json(Json::value_t::discarded);
    }
    if (!result.is_object()) {
        why = "not a JSON object";
        return Json(Json::value_t::discarded);
    }
    return result;
}

}  // namespace praxis::belief
