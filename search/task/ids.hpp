// Ids of the ground task.
#pragma once

#include "parser/ids.hpp"

namespace praxis {

using VariableId = Id<struct VariableTag>;
using OperatorId = Id<struct OperatorTag>;

}  // namespace praxis
