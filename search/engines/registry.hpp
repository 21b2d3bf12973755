// Every component that search expressions can name. `plan list` prints what these functions return.
#pragma once

#include <vector>

#include "search/engines/component.hpp"

namespace praxis {

/// Evaluators, open lists and engines, in the order in which a manual would present them.
std::vector<ComponentDescription> list_components();
std::vector<AliasDescription> list_aliases();

}  // namespace praxis
