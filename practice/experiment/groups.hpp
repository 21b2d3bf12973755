// Runs in the order of a report: by environment, then by method, each in the order of its first run.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace praxis::practice {

/// The runs of one method in one environment, as places in the list that was grouped.
struct MethodGroup {
    std::string method;
    std::vector<std::size_t> runs;
};

struct EnvironmentGroup {
    std::string environment;
    std::vector<MethodGroup> methods;
};

/// `Runs` is a list of what has an `environment` and a `method`.
template <class Runs>
std::vector<EnvironmentGroup> group_runs(const Runs& runs) {
    std::vector<EnvironmentGroup> groups;
    std::map<std::string, std::size_t> environments;
    std::vector<std::map<std::string, std::size_t>> methods;  // by environment
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto [e, new_environment] = environments.try_emplace(runs[i].environment, groups.size());
        if (new_environment) {
            groups.push_back({runs[i].environment, {}});
            methods.emplace_back();
        }
        std::vector<MethodGroup>& of_environment = groups[e->second].methods;
        const auto [m, new_method] = methods[e->second].try_emplace(runs[i].method, of_environment.size());
        if (new_method) of_environment.push_back({runs[i].method, {}});
        of_environment[m->second].runs.push_back(i);
    }
    return groups;
}

}  // namespace praxis::practice
