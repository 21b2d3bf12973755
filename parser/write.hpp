// Tasks as PDDL text again.
#pragma once

#include <string>

#include "parser/task.hpp"

namespace praxis {

/// The domain and the problem of a task; reading them gives an equal task (up to places, the numbers of
/// variables and, where a variable hides another one, their names). Constants are the objects that stand in
/// file 0. An initial value that no decimal number expresses is written as a fraction, which does not read
/// back.
std::string write_domain(const LiftedTask& task);
std::string write_problem(const LiftedTask& task);

}  // namespace praxis
