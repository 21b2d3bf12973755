// The environments that come with Praxis, by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "practice/environment.hpp"

namespace praxis::practice {

std::vector<std::string> environment_names();

/// Makes an environment from its name and options, such as `light-switch(cells=20)`,
/// `ball-ring(features=relative)` or `kitchen`. Throws std::invalid_argument with what there is for unknown
/// names, options and values.
std::unique_ptr<SimulatedEnvironment> make_environment(std::string_view expression);

}  // namespace praxis::practice
