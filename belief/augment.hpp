// The lifted task that is grounded for a contingent one.
//
// Uncertain atoms are in the initial state, and two schemas that no plan uses change them either way: so both
// values count as reachable, nothing takes them for static, and no mutex group contains them. Schemas that
// sense only and passive sensors get an effect on an atom of their own, so that the grounder keeps them.
#pragma once

#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "parser/contingent.hpp"

namespace praxis::belief {

struct Augmented {
    Task task;
    std::size_t schemas = 0;       ///< those of the source come first,
    std::size_t first_sensor = 0;  ///< then the auxiliary ones, then one a sensor
    /// The atoms that the initial description leaves open, by predicate, without duplicates.
    std::vector<Relation> uncertain;
};

/// Throws UnsupportedError where there would be too many uncertain atoms.
Augmented augment(const ContingentTask& source);

}  // namespace praxis::belief
