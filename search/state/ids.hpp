// Ids of stored states.
#pragma once

#include "parser/ids.hpp"

namespace praxis {

/// A state stored by one search; dense from 0 in the order of discovery.
using StateId = Id<struct StateTag>;

}  // namespace praxis
