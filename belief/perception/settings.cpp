#include "belief/perception/settings.hpp"

#include <cmath>
#include <cstdio>

#include "belief/perception/errors.hpp"
#include "belief/perception/json_answer.hpp"

namespace praxis::belief {
namespace {

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

bool within(const nlohmann::json& json, double low, double high) {
    if (!json.is_number()) return false;
    const double number = json.get<double>();
    return std::isfinite(number) && number >= low && number <= high;
}

std::string range(double low, double high) {
    return "from " + text_of(low) + " to " + text_of(high);
}

}  // namespace

Settings Settings::parse(std::string_view text, const std::string& name) {
    std::string why;
    auto root = std::make_shared<const Json>(read_json_answer(text, why));
    if (root->is_discarded()) throw PerceptionError(name + ": no JSON object: " + why);
    const Json* const json = root.get();
    return {std::move(root), json, name};
}

void Settings::fail(const std::string& member, const std::string& what) const {
    throw PerceptionError(place_ + ": '" + member + "' " + what);
}

const Settings::Json* Settings::find(const std::string& member) {
    read_.insert(member);
    const auto found = json_->find(member);
    return found == json_->end() ? nullptr : &*found;
}

const Settings::Json& Settings::get(const std::string& member) {
    const Json* const json = find(member);
    if (json == nullptr) fail(member, "is missing");
    return *json;
}

Settings Settings::part(const Json& json, const std::string& place) const {
    if (!json.is_object()) throw PerceptionError(place + " must be an object");
    return {root_, &json, place};
}

std::string Settings::text(const std::string& member) {
    const Json& json = get(member);
    if (!json.is_string() || json.get_ref<const std::string&>().empty()) fail(member, "must be a text");
    return json.get<std::string>();
}

std::string Settings::text(const std::string& member, const std::string& otherwise) {
    return find(member) == nullptr ? otherwise : text(member);
}

double Settings::number(const std::string& member, double low, double high, std::optional<double> otherwise) {
    if (otherwise && find(member) == nullptr) return *otherwise;
    const Json& json = get(member);
    if (!within(json, low, high)) fail(member, "must be a number " + range(low, high));
    return json.get<double>();
}

std::int64_t Settings::whole(const std::string& member, std::int64_t low, std::int64_t high,
                             std::optional<std::int64_t> otherwise) {
    if (otherwise && find(member) == nullptr) return *otherwise;
    const Json& json = get(member);
    if (!json.is_number_integer() || !within(json, static_cast<double>(low), static_cast<double>(high)))
        fail(member, "must be a whole number " + range(static_cast<double>(low), static_cast<double>(high)));
    return json.get<std::int64_t>();
}

bool Settings::flag(const std::string& member, bool otherwise) {
    const Json* const json = find(member);
    if (json == nullptr) return otherwise;
    if (!json->is_boolean()) fail(member, "must be true or false");
    return json->get<bool>();
}

std::vector<double> Settings::numbers(const std::string& member, std::size_t count, double low, double high) {
    const Json& json = get(member);
    bool right = json.is_array() && json.size() == count;
    for (std::size_t i = 0; right && i < count; ++i) right = within(json[i], low, high);
    if (!right) fail(member, "must be a list of " + std::to_string(count) + " numbers " + range(low, high));
    return json.get<std::vector<double>>();
}

Settings Settings::object(const std::string& member) {
    return part(get(member), place_ + ": '" + member + "'");
}

std::vector<Settings> Settings::objects(const std::string& member) {
    const Json& json = get(member);
    if (!json.is_array() || json.empty()) fail(member, "must be a list of objects");
    std::vector<Settings> result;
    for (const Json& item : json)
        result.push_back(part(item, place_ + ": '" + member + "' " + std::to_string(result.size() + 1)));
    return result;
}

std::vector<std::pair<std::string, Settings>> Settings::named_objects(const std::string& member) {
    std::vector<std::pair<std::string, Settings>> result;
    if (find(member) == nullptr) return result;
    const Settings all = object(member);
    for (const auto& [name, value] : all.json_->items())
        result.emplace_back(name, part(value, all.place_ + ": '" + name + "'"));
    return result;
}

std::vector<std::pair<std::string, std::string>> Settings::named_texts(const std::string& member) {
    std::vector<std::pair<std::string, std::string>> result;
    if (find(member) == nullptr) return result;
    Settings all = object(member);
    for (const auto& item : all.json_->items()) result.emplace_back(item.key(), all.text(item.key()));
    return result;
}

std::string Settings::raw(const std::string& member) {
    if (find(member) == nullptr) return {};
    return object(member).json_->dump();
}

void Settings::finish() const {
    for (const auto& item : json_->items())
        if (!read_.contains(item.key())) fail(item.key(), "is not a setting");
}

}  // namespace praxis::belief
