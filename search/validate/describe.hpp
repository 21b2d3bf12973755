// Formulas and places as people write them, for the reason of a verdict.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "parser/task.hpp"

namespace praxis::validation {

/// The object that a variable of the scope stands for; an invalid id leaves the variable's name.
using Binding = std::function<ObjectId(std::uint32_t variable)>;

/// The formula in PDDL with the bound variables replaced; a long one is cut off with "...".
std::string describe(const Formula& formula, const Scope& scope, const LiftedTask& task,
                     const Binding& binding);

/// " (file.pddl:12:7)"; empty if the task has no source for it.
std::string describe(const Location& where, const LiftedTask& task);

/// "(name a b)".
std::string describe(const std::string& name, std::span<const ObjectId> arguments, const LiftedTask& task);

}  // namespace praxis::validation
