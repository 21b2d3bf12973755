// Observable atoms as derived ones: the lifted task with an axiom for each rule of a sensing model.
#pragma once

#include "parser/contingent.hpp"

namespace praxis::belief {

/// The lifted task in which those observable atoms that conditions mention are derived from what sensing
/// models say of them. For validation and tests; the ground task has variables for them, see SensingModels.
LiftedTask with_observable_axioms(const ContingentTask& task);

}  // namespace praxis::belief
