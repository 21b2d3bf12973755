#include "learned/weights/planner_json.hpp"

#include <limits>
#include <stdexcept>

namespace praxis::learned {
namespace {

// Calls visit(name, member) for every option.
template <class Options, class Visit>
void for_members(Options& options, const Visit& visit) {
    visit("model", options.model);
    visit("group", options.group);
    visit("fields", options.fields);
    visit("iterations", options.iterations);
    visit("radius", options.radius);
    visit("input_radius", options.input_radius);
    visit("padding", options.padding);
    visit("contraction", options.contraction);
    visit("differentiation", options.differentiation);
    visit("tolerance", options.tolerance);
    visit("backward_iterations", options.backward_iterations);
    visit("anderson", options.anderson);
}

const char* name_of(Padding padding) {
    return padding == Padding::zero ? "zero" : "circular";
}
const char* name_of(Differentiation way) {
    return way == Differentiation::unrolled ? "unrolled" : "implicit";
}

nlohmann::json value_of(const std::string& value) {
    return value;
}
nlohmann::json value_of(int value) {
    return value;
}
nlohmann::json value_of(double value) {
    return value;
}
template <class Enum>
requires std::is_enum_v<Enum> nlohmann::json value_of(Enum value) {
    return name_of(value);
}

bool read(const nlohmann::json& json, std::string& value) {
    if (!json.is_string()) return false;
    value = json.get<std::string>();
    return true;
}
bool read(const nlohmann::json& json, int& value) {
    if (!json.is_number_integer()) return false;
    const auto wide = json.get<std::int64_t>();
    if (wide < 0 || wide > std::numeric_limits<int>::max()) return false;
    value = static_cast<int>(wide);
    return true;
}
bool read(const nlohmann::json& json, double& value) {
    if (!json.is_number()) return false;
    value = json.get<double>();
    return true;
}
template <class Enum>
requires std::is_enum_v<Enum>
bool read(const nlohmann::json& json, Enum& value) {
    for (const Enum known : {static_cast<Enum>(0), static_cast<Enum>(1)})
        if (json == name_of(known)) {
            value = known;
            return true;
        }
    return false;
}

}  // namespace

nlohmann::json to_json(const PlannerOptions& options) {
    nlohmann::json result = nlohmann::json::object();
    for_members(options, [&](const char* name, const auto& member) { result[name] = value_of(member); });
    return result;
}

PlannerOptions planner_options(const nlohmann::json& json) {
    if (!json.is_object()) throw std::invalid_argument("the options of a planner are not a JSON object");
    PlannerOptions result;
    std::size_t members = 0;
    for_members(result, [&](const char* name, auto& member) {
        ++members;
        const auto found = json.find(name);
        if (found == json.end())
            throw std::invalid_argument(std::string("the planner's option '") + name + "' is missing");
        if (!read(*found, member))
            throw std::invalid_argument(std::string("the planner's option '") + name +
                                        "' has no sensible value");
    });
    if (json.size() != members)
        throw std::invalid_argument("there are options of a planner that this program does not know");
    return result;
}

}  // namespace praxis::learned
