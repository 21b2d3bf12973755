// Facts of which exactly one holds, as long as actions keep it so.
#pragma once

#include <optional>
#include <span>

#include "search/task/finite_domain_task.hpp"

namespace praxis::belief {

/// An operator that does not visibly keep it so that exactly one of the facts holds: it takes one away and
/// gives none, or gives one and does not take away the others. Nothing if all do. The facts' variables have
/// two values.
std::optional<OperatorId> breaks_choice(const FiniteDomainTask& task, std::span<const Fact> choice);

}  // namespace praxis::belief
