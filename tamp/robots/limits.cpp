#include "tamp/robots/limits.hpp"

#include "parser/files.hpp"
#include "parser/suggest.hpp"
#include "tamp/text/yaml_document.hpp"

namespace praxis::tamp {

namespace {

/// The entries of an optional part of the file.
template <class Read>
void for_each_limit(const YamlDocument& yaml, const char* part, Read read) {
    const YAML::Node map = YamlDocument::find(yaml.root(), part);
    if (!is_given(map)) return;
    yaml.require_map(map, quote(part));
    for (const auto& item : map) {
        const std::string name = yaml.text(item.first, "the name of a variable");
        read(name, item.second, std::string("the limit of ") + part + " of " + quote(name));
    }
}

}  // namespace

MotionLimits parse_limits(const Source& source) {
    const YamlDocument yaml(source);
    yaml.require_keys(yaml.root(), "the file", {"position", "velocity", "acceleration"});
    MotionLimits limits;
    for_each_limit(yaml, "position",
                   [&](const std::string& name, const YAML::Node& node, const std::string& what) {
                       const std::vector<double> range = yaml.numbers(node, what, 2);
                       if (range[0] > range[1])
                           yaml.fail(node, what + " has its lower end above its upper one", "exchange them");
                       limits.position[name] = {range[0], range[1]};
                   });
    for_each_limit(yaml, "velocity",
                   [&](const std::string& name, const YAML::Node& node, const std::string& what) {
                       limits.velocity[name] = yaml.length(node, what);
                   });
    for_each_limit(yaml, "acceleration",
                   [&](const std::string& name, const YAML::Node& node, const std::string& what) {
                       limits.acceleration[name] = yaml.length(node, what);
                   });
    return limits;
}

MotionLimits read_limits(const std::string& file) {
    return parse_limits(read_source(file));
}

}  // namespace praxis::tamp
