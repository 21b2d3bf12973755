// What a skill costs in a plan: how unlikely it is to succeed.
//
// A plan succeeds with the product of its skills' competences, so that with the cost -log c of a skill the
// cheapest plan is the one most likely to succeed; -log p of an uncertain reading is a cost of the same kind,
// and both may be added to other costs that are expressed in nats. Costs are 64-bit integers of 2^-40 nat, so
// that sums are exact whatever their order, and each skill costs one unit more than -log c: of two equally
// likely plans the shorter one is cheaper. Two plans of n skills are ordered rightly if their
// log-probabilities differ by more than n * 2^-40. A plan of 200,000 skills of competence 1e-6 still fits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace praxis::practice {

using Cost = std::int64_t;

inline constexpr Cost kNoPlan = std::numeric_limits<Cost>::max();
inline constexpr double kUnitsPerNat = 0x1.0p40;
/// Competences below this count as this.
inline constexpr double kLeastCompetence = 1e-6;

/// The cost of a skill that succeeds with this probability. NaN counts as kLeastCompetence.
inline Cost success_cost(double competence) {
    const double c = competence >= kLeastCompetence ? std::min(competence, 1.0) : kLeastCompetence;
    return std::llround(-std::log(c) * kUnitsPerNat) + 1;
}
inline double nats(Cost cost) {
    return static_cast<double>(cost) / kUnitsPerNat;
}

}  // namespace praxis::practice
