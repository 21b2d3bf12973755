// Ground tasks as files: the SAS+ format, version 3, of Fast Downward's translator, read and written.
//
// Sections, in this order: version, metric, variables (axiom layer, domain size, fact names), mutex groups,
// initial state, goal, operators (prevail conditions, then effects "conditions... variable pre post", then
// the cost) and axioms. An effect's `pre` is a precondition of the whole operator. Derived variables are
// binary and their default is their value in the initial state. See "Output of the Fast Downward translator"
// in Fast Downward's documentation.
#pragma once

#include <iosfwd>

#include "parser/source.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Reads a whole file. Conditions are sorted and repeated facts in them dropped. Throws InputError with the
/// place of the first mistake: malformed, truncated or trailing text, numbers out of range, contradictory
/// conditions, axioms that break the layers. Memory stays within a small factor of the text, whatever counts
/// the text claims.
FiniteDomainTask read_sas(const Source& source);

/// Writes what Fast Downward's search component accepts. Costs are written as they are stored, in units of
/// 1/cost_scale. The format has no operators without effects: they are left out (so operator numbers may
/// shift). It has no empty goal and no "proved unsolvable" either: such tasks get one more variable with a
/// goal for it, met or unreachable.
void write_sas(const FiniteDomainTask& task, std::ostream& out);

}  // namespace praxis
