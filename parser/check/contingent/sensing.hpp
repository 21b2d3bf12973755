// Observations and sensing models of actions, sensors, and the default sensing model.
#pragma once

#include <cstddef>

#include "parser/check/scope.hpp"

namespace praxis::check {

/// Fills in `readings` of the context: the predicates whose atoms are values of an `:obs-variable` of the
/// tree.
void collect_readings(Context& context, const syntax::Tree& tree);

/// Reads what the schema that was made last senses; `next` is the first entry of ContingentTree::actions that
/// may belong to it, the result the first that does not.
std::size_t check_action_sensing(ScopeBuilder& scope, std::size_t next);

/// To be called when the variables are ground: rules over predicates that turn out to have no observable atom
/// are readings of their atoms.
void settle_rules(Context& context);

void check_sensors(Context& context, const syntax::Tree& domain);
void check_default_model(Context& context, const syntax::Tree& domain);

}  // namespace praxis::check
