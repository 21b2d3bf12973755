#include "tamp/robots/limits.hpp"

#include "parser/files.hpp"
#include "tamp/robots/yaml_file.hpp"

namespace praxis::tamp {

namespace {

std::map<std::string, double> rates(const YamlFile& yaml, const char* key) {
    std::map<std::string, double> limits;
    const YAML::Node part = yaml.root()[key];
    if (!part) return limits;
    yaml.require_map(part);
    for (const auto& item : part) {
        const double limit = yaml.number(item.second);
        if (!(limit > 0)) yaml.fail(item.second, "a limit must be above 0");
        limits[yaml.text(item.first)] = limit;
    }
    return limits;
}

}  // namespace

MotionLimits parse_limits(const Source& source) {
    const YamlFile yaml(source);
    yaml.require_keys(yaml.root(), {"position", "velocity", "acceleration"});
    MotionLimits limits{.velocity = rates(yaml, "velocity"), .acceleration = rates(yaml, "acceleration")};
    if (const YAML::Node part = yaml.root()["position"]) {
        yaml.require_map(part);
        for (const auto& item : part) {
            const std::vector<double> range = yaml.numbers(item.second, 2);
            if (range[0] > range[1]) yaml.fail(item.second, "the lower limit is above the upper one");
            limits.position[yaml.text(item.first)] = {range[0], range[1]};
        }
    }
    return limits;
}

MotionLimits read_limits(const std::string& file) {
    return parse_limits(read_source(file));
}

}  // namespace praxis::tamp
