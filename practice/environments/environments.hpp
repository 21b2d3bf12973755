// The environments that come with Praxis, by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "practice/component.hpp"
#include "practice/environment.hpp"

namespace praxis::practice {

std::vector<std::string> environment_names();
/// The same with their options and defaults, such as `light-switch(cells=100)`, and what they are.
std::vector<Component> environments();

/// Makes an environment from its name and options, such as `light-switch(cells=20)`,
/// `ball-ring(features=relative)` or `kitchen`. Throws std::invalid_argument with what there is for unknown
/// names, options and values.
std::unique_ptr<SimulatedEnvironment> make_environment(std::string_view expression);

/// One text for one environment: options that have their default value are left out. Throws as
/// `make_environment` does for unknown names and options.
std::string canonical_environment(std::string_view expression);

}  // namespace praxis::practice
